// On which side points lie, with the exact sign for any coordinates that do not over- or underflow: plain
// arithmetic where its error bound tells that the sign is right, else exact sums of doubles that do not
// overlap (Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates,
// 1997).
#pragma once

#include "base/points.h"

namespace drape {

// Of (b - a) x (c - a) . (d - a): 1, -1, or 0 where the four lie in one plane.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

// Of (b - a) x (c - a): 1 where a, b, c turn left.
int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

}  // namespace drape
