// Plane: distance n . (p - c).
#include <limits>

#include "base/rigid_motion.h"
#include "obstacle/kinds.h"

namespace drape {

namespace {

class Plane final : public Solid {
public:
    Plane(const Vec3& centre, const Vec3& normal) : centre_(centre), normal_(normal) {}

    SurfaceSample sample(const Vec3& p) const override { return {normal_.dot(p - centre_), normal_}; }
    double sagitta(double) const override { return 0; }
    Vec3 centre() const override { return centre_; }
    double reach() const override { return std::numeric_limits<double>::infinity(); }

    Mesh surface(double extent) const override {
        const Mat3 turn = rotation_from_up(normal_);
        Points corners(3, 4);
        corners << -1, -1, 1, 1, 0, 0, 0, 0, -1, 1, 1, -1;
        corners = ((turn * corners) * (extent / 2)).colwise() + centre_;
        Faces faces(3, 2);
        faces << 0, 0, 1, 2, 2, 3;
        return plain_mesh(corners, faces);
    }

private:
    Vec3 centre_, normal_;
};

}  // namespace

std::unique_ptr<Solid> make_plane(const ShapeParameters& p) {
    return std::make_unique<Plane>(p.centre, require_direction("normal", p.normal));
}

}  // namespace drape
