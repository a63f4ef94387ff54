// Vertices of four doubles, x y z 0: a vertex is one load, four of them are turned into lanes by shuffles,
// and no store overlaps the next vertex's, which a load after it would wait for.
#pragma once

#include "base/lanes.h"
#include "base/points.h"

namespace drape {

using PaddedPoints = Eigen::Matrix4Xd;

// Takes over `points`; resizes.
void pad(In points, PaddedPoints& padded);

// The other way; resizes.
void unpad(const PaddedPoints& padded, Points& points);

namespace lanes {

// Four vertices' coordinate, each.
struct Vertices {
    Lanes x, y, z;
};

inline __attribute__((always_inline)) Lanes dot(const Vertices& a, const Vertices& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// The columns of four padded vertices.
inline __attribute__((always_inline)) Vertices transposed(const Lanes (&row)[4]) {
    const Lanes xz_low = __builtin_shufflevector(row[0], row[1], 0, 4, 2, 6);
    const Lanes xz_high = __builtin_shufflevector(row[2], row[3], 0, 4, 2, 6);
    const Lanes y_low = __builtin_shufflevector(row[0], row[1], 1, 5, 3, 7);
    const Lanes y_high = __builtin_shufflevector(row[2], row[3], 1, 5, 3, 7);
    return {__builtin_shufflevector(xz_low, xz_high, 0, 1, 4, 5),
            __builtin_shufflevector(y_low, y_high, 0, 1, 4, 5),
            __builtin_shufflevector(xz_low, xz_high, 2, 3, 6, 7)};
}

// The sum over each of four rows, (x + y) + (z + 0).
inline __attribute__((always_inline)) Lanes row_sums(const Lanes& a, const Lanes& b, const Lanes& c,
                                                     const Lanes& d) {
    const Lanes ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Lanes cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
    return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

}  // namespace lanes
}  // namespace drape
