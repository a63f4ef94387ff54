// Sphere: distance |p - c| - r. At the very centre the normal is up.
#include <cmath>
#include <numbers>

#include "obstacle/kinds.h"
#include "obstacle/tessellate.h"

namespace drape {

namespace {

class Sphere final : public Solid {
public:
    Sphere(const Vec3& centre, double radius) : centre_(centre), radius_(radius) {}

    SurfaceSample sample(const Vec3& p) const override {
        const Vec3 offset = p - centre_;
        const double length = offset.norm();
        if (length == 0) return {-radius_, Vec3::UnitY()};
        return {length - radius_, offset / length};
    }
    double sagitta(double spacing) const override { return round_sagitta(radius_, spacing); }
    Vec3 centre() const override { return centre_; }
    double reach() const override { return radius_; }

    Mesh surface(double) const override {
        std::vector<ProfilePoint> profile;
        for (int i = 0; i <= 48; ++i) {
            const double angle = std::numbers::pi * (i / 48.0 - 0.5);
            profile.push_back({i % 48 == 0 ? 0 : radius_ * std::cos(angle), radius_ * std::sin(angle)});
        }
        return revolve(profile, false, centre_, Vec3::UnitY());
    }

private:
    Vec3 centre_;
    double radius_;
};

}  // namespace

std::unique_ptr<Solid> make_sphere(const ShapeParameters& p) {
    require_positive("radius", p.radius);
    return std::make_unique<Sphere>(p.centre, p.radius);
}

}  // namespace drape
