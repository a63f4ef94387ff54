// Torus: distance to the ring of radius R about the axis, less the tube's radius.
// On the axis, and on the ring itself, the normal is any one of those that are equally near.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "obstacle/kinds.h"
#include "obstacle/tessellate.h"

namespace drape {

namespace {

class Torus final : public Solid {
public:
    Torus(const Vec3& centre, const Vec3& axis, double ring, double tube)
        : centre_(centre), axis_(axis), ring_(ring), tube_(tube) {}

    SurfaceSample sample(const Vec3& p) const override {
        const Vec3 offset = p - centre_;
        const double height = offset.dot(axis_);
        const Vec3 across = offset - height * axis_;
        const double radius = across.norm();
        const Vec3 radial = radius > round_off * ring_ ? Vec3(across / radius) : axis_.unitOrthogonal();
        const double q = radius - ring_, length = std::hypot(q, height);
        if (length <= round_off * tube_) return {-tube_, axis_};
        return {length - tube_, (q * radial + height * axis_) / length};
    }
    double sagitta(double spacing) const override { return round_sagitta(tube_, spacing); }
    Vec3 centre() const override { return centre_; }
    double reach() const override { return ring_ + tube_; }

    Mesh surface(double) const override {
        std::vector<ProfilePoint> profile;
        for (int i = 0; i < 48; ++i) {
            const double angle = 2 * std::numbers::pi * i / 48;
            profile.push_back({ring_ + tube_ * std::cos(angle), tube_ * std::sin(angle)});
        }
        return revolve(profile, true, centre_, axis_, 128);
    }

private:
    Vec3 centre_, axis_;
    double ring_, tube_;
};

}  // namespace

std::unique_ptr<Solid> make_torus(const ShapeParameters& p) {
    require_positive("radius", p.radius);
    require_positive("tube_radius", p.tube_radius);
    if (p.tube_radius >= p.radius)
        throw Error(
            cat("tube_radius must be smaller than radius, got ", p.tube_radius, " and ", p.radius, " m"));
    return std::make_unique<Torus>(p.centre, require_direction("axis", p.axis), p.radius, p.tube_radius);
}

}  // namespace drape
