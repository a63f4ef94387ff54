// Box: with q = |p| - (half - rounding) in its own frame, outside the distance is |max(q, 0)| - rounding,
// inside the nearest face's. Where two faces are equally near, the first axis wins.
#include <algorithm>

#include "base/error.h"
#include "obstacle/kinds.h"
#include "obstacle/tessellate.h"

namespace drape {

namespace {

class Box final : public Solid {
public:
    Box(const Vec3& centre, const Mat3& rotation, const Vec3& half, double rounding)
        : centre_(centre), rotation_(rotation), half_(half), rounding_(rounding) {}

    SurfaceSample sample(const Vec3& p) const override {
        const Vec3 local = rotation_.transpose() * (p - centre_);
        const Vec3 q = local.cwiseAbs() - (half_ - Vec3::Constant(rounding_));
        Vec3 outward = q.cwiseMax(0.0);
        double distance = outward.norm();
        if (distance > 0) {
            outward /= distance;
        } else {
            int nearest = 0;
            distance = q.maxCoeff(&nearest);
            outward = Vec3::Unit(nearest);
        }
        for (int c = 0; c < 3; ++c)
            if (local[c] < 0) outward[c] = -outward[c];
        return {distance - rounding_, rotation_ * outward};
    }
    double sagitta(double spacing) const override {
        // s / (2 sqrt 2) across an edge, s sqrt 2 / 3 across a corner, s / 2 through a slab
        return std::min(edge_sagitta(spacing / 2, rounding_, spacing), half_.minCoeff());
    }
    Vec3 centre() const override { return centre_; }
    double reach() const override { return half_.norm(); }

    Mesh surface(double) const override {
        Mesh mesh = rounded_box(half_, rounding_);
        mesh.rest = (rotation_ * mesh.rest).colwise() + centre_;
        return mesh;
    }

private:
    Vec3 centre_;
    Mat3 rotation_;
    Vec3 half_;
    double rounding_;
};

}  // namespace

std::unique_ptr<Solid> make_box(const ShapeParameters& p) {
    require_positive("size", p.size.minCoeff());
    if (p.rounding < 0 || p.rounding > p.size.minCoeff() / 2)
        throw Error(cat("rounding must be between 0 and half the smallest side, got ", p.rounding, " m"));
    return std::make_unique<Box>(p.centre, rotation_from_degrees(p.rotate_deg), p.size / 2, p.rounding);
}

}  // namespace drape
