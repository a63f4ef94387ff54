// Capsule: all points within r of the segment a-b. On the segment itself the normal is any one across it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "obstacle/kinds.h"
#include "obstacle/tessellate.h"

namespace drape {

namespace {

class Capsule final : public Solid {
public:
    Capsule(const Vec3& a, const Vec3& b, double radius)
        : a_(a), ab_(b - a), inverse_squared_(1 / ab_.squaredNorm()), radius_(radius) {}

    SurfaceSample sample(const Vec3& p) const override {
        const Vec3 from_a = p - a_;
        const double s = std::clamp(from_a.dot(ab_) * inverse_squared_, 0.0, 1.0);
        const Vec3 offset = from_a - s * ab_;
        const double length = offset.norm();
        if (length <= round_off * radius_) return {-radius_, ab_.unitOrthogonal()};
        return {length - radius_, offset / length};
    }
    double sagitta(double spacing) const override { return round_sagitta(radius_, spacing); }
    Vec3 centre() const override { return a_ + ab_ / 2; }
    double reach() const override { return ab_.norm() / 2 + radius_; }

    Mesh surface(double) const override {
        const double half = ab_.norm() / 2;
        std::vector<ProfilePoint> profile;
        for (const double end : {-1.0, 1.0}) {
            for (int i = 0; i <= 24; ++i) {
                const double angle = std::numbers::pi / 2 * (end < 0 ? i / 24.0 - 1 : i / 24.0);
                const bool pole = end < 0 ? i == 0 : i == 24;
                profile.push_back(
                    {pole ? 0 : radius_ * std::cos(angle), end * half + radius_ * std::sin(angle)});
            }
        }
        return revolve(profile, false, centre(), ab_.normalized());
    }

private:
    Vec3 a_, ab_;
    double inverse_squared_, radius_;
};

}  // namespace

std::unique_ptr<Solid> make_capsule(const ShapeParameters& p) {
    require_positive("radius", p.radius);
    if (p.from == p.to) throw Error("capsule: from and to are the same point (use a sphere)");
    return std::make_unique<Capsule>(p.from, p.to, p.radius);
}

}  // namespace drape
