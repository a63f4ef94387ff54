// Triangles of a file. What cloth meets are the triangles themselves (contact/self_contact.h); the distance
// here is that of the box around them, which only bounds it.
#include <cmath>

#include "obstacle/obstacle.h"

namespace drape {

namespace {

class MeshSolid final : public Solid {
public:
    explicit MeshSolid(Mesh mesh) : mesh_(std::move(mesh)) {
        for (int i = 0; i < mesh_.vertices(); ++i) box_.extend(Vec3(mesh_.rest.col(i)));
    }

    SurfaceSample sample(const Vec3& p) const override {
        const Vec3 way = p - p.cwiseMax(box_.min()).cwiseMin(box_.max());
        const double distance = way.norm();
        if (distance == 0) return {};
        return {distance, way / distance};
    }
    double sagitta(double) const override { return 0; }
    Vec3 centre() const override { return box_.center(); }
    double reach() const override { return box_.diagonal().norm() / 2; }
    const Mesh* triangles() const override { return &mesh_; }
    Mesh surface(double) const override { return mesh_; }

private:
    Mesh mesh_;
    Eigen::AlignedBox3d box_;
};

}  // namespace

std::unique_ptr<Solid> make_mesh(Mesh mesh) {
    return std::make_unique<MeshSolid>(std::move(mesh));
}

}  // namespace drape
