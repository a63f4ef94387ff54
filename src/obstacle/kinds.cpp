#include "obstacle/kinds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace drape {

void require_positive(std::string_view what, double value) {
    if (!(value > 0)) throw Error(cat(what, " must be positive, got ", value, " m"));
}

Vec3 require_direction(std::string_view what, const Vec3& v) {
    const double length = v.norm();
    if (!(length > 0)) throw Error(cat(what, " must not be zero"));
    return v / length;
}

double round_sagitta(double radius, double spacing) {
    const double a = spacing / std::numbers::sqrt3;
    return a < radius ? radius - std::sqrt(radius * radius - a * a) : radius;
}

double edge_sagitta(double sharp, double rounding, double spacing) {
    const double cut = sharp + (1 - std::numbers::inv_sqrt3) * rounding;
    const bool within_the_round = spacing < std::numbers::sqrt3 * rounding;
    return within_the_round ? std::min(cut, round_sagitta(rounding, spacing)) : cut;
}

}  // namespace drape
