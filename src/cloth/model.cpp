#include "cloth/model.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"

namespace drape {

namespace {

Eigen::VectorXd lumped_area(const Mesh& mesh) {
    Eigen::VectorXd area = Eigen::VectorXd::Zero(mesh.vertices());
    for (int f = 0; f < mesh.triangles(); ++f) {
        const Vec3 a = mesh.rest.col(mesh.faces(0, f));
        const Vec3 b = mesh.rest.col(mesh.faces(1, f));
        const Vec3 c = mesh.rest.col(mesh.faces(2, f));
        for (int k = 0; k < 3; ++k) area[mesh.faces(k, f)] += (b - a).cross(c - a).norm() / 6;
    }
    return area;
}

}  // namespace

Cloth make_cloth(Mesh mesh, const Fabric& fabric) {
    Cloth cloth;
    cloth.mesh = std::move(mesh);
    cloth.topology = build_topology(cloth.mesh.faces, cloth.mesh.vertices());
    cloth.fabric = fabric;
    cloth.area = lumped_area(cloth.mesh);
    cloth.mass = fabric.density * cloth.area;
    cloth.network = build_network(cloth.mesh, cloth.topology, fabric, cloth.mass);
    return cloth;
}

void add_cloth(Model& model, Cloth cloth) {
    cloth.first = model.vertices();
    const Eigen::Index total = cloth.first + cloth.vertices();
    model.mass.conservativeResize(total);
    model.mass.tail(cloth.vertices()) = cloth.mass;
    model.inverse_mass.conservativeResize(total);
    model.inverse_mass.tail(cloth.vertices()) = cloth.mass.cwiseInverse();
    model.cloths.push_back(std::move(cloth));
}

void add_pins(Model& model, PinGroup group) {
    DRAPE_ASSERT(group.anchors.cols() == static_cast<Eigen::Index>(group.vertices.size()));
    for (const int v : group.vertices) model.inverse_mass[v] = 0;
    model.pins.push_back(std::move(group));
}

bool has_jumping_forces(const Model& model) {
    return std::any_of(model.cloths.begin(), model.cloths.end(),
                       [](const Cloth& cloth) { return cloth.fabric.altitude == AltitudeMode::shortest; });
}

bool has_moving_pins(const Model& model) {
    return std::any_of(model.pins.begin(), model.pins.end(),
                       [](const PinGroup& group) { return group.motion.moves(); });
}

void place_pins(const Model& model, State& state) {
    for (const PinGroup& group : model.pins) {
        const MovingPose moving = group.motion.at(state.time);
        for (size_t i = 0; i < group.vertices.size(); ++i) {
            const int v = group.vertices[i];
            const Vec3 anchor = group.anchors.col(static_cast<Eigen::Index>(i));
            Vec3 arm = anchor - group.about, turning = Vec3::Zero();
            if (group.rigid) {
                arm = moving.pose.rotation * arm;
                turning = moving.angular.cross(arm);
            }
            state.x.col(v) = group.about + moving.pose.translation + arm;
            state.v.col(v) = moving.linear + turning;
        }
    }
}

}  // namespace drape
