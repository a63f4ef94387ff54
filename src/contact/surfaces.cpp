#include "contact/surfaces.h"

#include <algorithm>

namespace drape {

namespace {

// all that is asked of a surface
Cloth surface_of(const Cloth& cloth) {
    Cloth surface;
    surface.mesh = cloth.mesh;
    surface.topology = cloth.topology;
    surface.mass = cloth.mass;
    surface.area = cloth.area;
    surface.self_contact = true;
    return surface;
}

Cloth surface_of(const Mesh& mesh) {
    Cloth surface = make_cloth(mesh, {});
    surface.self_contact = true;
    return surface;
}

}  // namespace

Surfaces::Surfaces(const Model& cloths, const std::vector<Obstacle>& obstacles) : cloths_(cloths) {
    std::copy_if(obstacles.begin(), obstacles.end(), std::back_inserter(meshes_),
                 [](const Obstacle& obstacle) { return obstacle.solid->triangles() != nullptr; });
    if (meshes_.empty()) return;
    Model& all = with_meshes_.emplace();
    for (const Cloth& cloth : cloths.cloths) add_cloth(all, surface_of(cloth));
    for (const Obstacle& obstacle : meshes_) add_cloth(all, surface_of(*obstacle.solid->triangles()));
    all.inverse_mass.setZero();
    all.inverse_mass.head(columns()) = cloths.inverse_mass;
    x_ = v_ = move_ = Points::Zero(3, all.vertices());
}

const Obstacle* Surfaces::mesh(int surface) const {
    const int cloths = static_cast<int>(cloths_.cloths.size());
    return surface < cloths ? nullptr : &meshes_[static_cast<size_t>(surface - cloths)];
}

bool Surfaces::meet(int surface, int other) const {
    if (mesh(surface) || mesh(other)) return !(mesh(surface) && mesh(other));
    return cloths_.cloths[static_cast<size_t>(surface)].self_contact &&
           cloths_.cloths[static_cast<size_t>(other)].self_contact;
}

void Surfaces::place_meshes(double time) {
    if (time_ == time) return;
    for (int surface = static_cast<int>(cloths_.cloths.size()); surface < count(); ++surface) {
        const Cloth& cloth = with_meshes_->cloths[static_cast<size_t>(surface)];
        const RigidMotion& motion = mesh(surface)->motion;
        if (time_ && !motion.moves()) continue;
        const MovingPose moving = motion.at(time);
        for (int i = 0; i < cloth.vertices(); ++i) {
            const Vec3 at = moving.pose * Vec3(cloth.mesh.rest.col(i));
            x_.col(cloth.first + i) = at;
            v_.col(cloth.first + i) = motion.moves() ? moving.velocity_at(at) : Vec3::Zero();
        }
    }
    time_ = time;
}

Eigen::Ref<const Points> Surfaces::positions(In x, double time) {
    if (!with_meshes_) return x;
    place_meshes(time);
    x_.leftCols(columns()) = x;
    return x_;
}

Eigen::Ref<const Points> Surfaces::velocities(In v, double time) {
    if (!with_meshes_) return v;
    place_meshes(time);
    v_.leftCols(columns()) = v;
    return v_;
}

Eigen::Ref<const Points> Surfaces::moves(In move) {
    if (!with_meshes_) return move;
    move_.leftCols(columns()) = move;
    return move_;
}

}  // namespace drape
