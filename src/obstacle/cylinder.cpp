// Cylinder with flat caps: a rounded rectangle in (distance from the axis, height), turned about the axis.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "obstacle/kinds.h"
#include "obstacle/tessellate.h"

namespace drape {

namespace {

class Cylinder final : public Solid {
public:
    Cylinder(const Vec3& centre, const Vec3& axis, double radius, double height, double rounding)
        : centre_(centre), axis_(axis), radius_(radius), half_(height / 2), rounding_(rounding) {}

    SurfaceSample sample(const Vec3& p) const override {
        const Vec3 offset = p - centre_;
        const double height = offset.dot(axis_);
        const Vec3 across = offset - height * axis_;
        const double radius = across.norm();
        const Vec3 radial = radius > round_off * radius_ ? Vec3(across / radius) : axis_.unitOrthogonal();
        const Vec3 axial = height < 0 ? Vec3(-axis_) : axis_;
        const double q = radius - (radius_ - rounding_), h = std::abs(height) - (half_ - rounding_);
        if (q > 0 && h > 0) {
            const double corner = std::hypot(q, h);
            return {corner - rounding_, (q * radial + h * axial) / corner};
        }
        return q > h ? SurfaceSample{q - rounding_, radial} : SurfaceSample{h - rounding_, axial};
    }
    double sagitta(double spacing) const override {
        // across a rim, where the bent side's own dip comes on top; or right through a disc
        const double rim = spacing / (2 * std::numbers::sqrt2) + round_sagitta(radius_, spacing);
        const double sharp = spacing < 2 * half_ ? rim : std::max(rim, half_);
        return std::min({edge_sagitta(sharp, rounding_, spacing), radius_, half_});
    }
    Vec3 centre() const override { return centre_; }
    double reach() const override { return std::hypot(radius_, half_); }

    Mesh surface(double) const override {
        const double r = radius_ - rounding_, h = half_ - rounding_;
        std::vector<ProfilePoint> profile{{0, -half_}};
        for (const double end : {-1.0, 1.0}) {
            for (int i = 0; i <= 8; ++i) {
                const double angle = std::numbers::pi / 2 * (end < 0 ? i / 8.0 - 1 : i / 8.0);
                profile.push_back({r + rounding_ * std::cos(angle), end * h + rounding_ * std::sin(angle)});
            }
        }
        profile.push_back({0, half_});
        return revolve(profile, false, centre_, axis_);
    }

private:
    Vec3 centre_, axis_;
    double radius_, half_, rounding_;
};

}  // namespace

std::unique_ptr<Solid> make_cylinder(const ShapeParameters& p) {
    require_positive("radius", p.radius);
    require_positive("height", p.height);
    if (p.rounding < 0 || p.rounding > std::min(p.radius, p.height / 2))
        throw Error(cat("rounding must be between 0 and the smaller of radius and half height, got ",
                        p.rounding, " m"));
    return std::make_unique<Cylinder>(p.centre, require_direction("axis", p.axis), p.radius, p.height,
                                      p.rounding);
}

}  // namespace drape
