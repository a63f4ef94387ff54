// Which triangles of a surface cross each other, told by exact signs alone: the referee of contact between
// cloth and cloth, with which it shares no code.
//
// Two triangles that share no vertex cross if they have a point in common, be it that they only touch. Of two
// that share one vertex, either's opposite side must meet the other. Two that share an edge cross only where
// one is folded flat onto the other, which is not looked for.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "base/points.h"

namespace drape {

struct Crossings {
    int pairs = 0;                          // of triangles
    int triangles = 0;                      // that cross any other
    std::array<int, 2> first{-1, -1};       // the pair of the lowest numbers
    std::vector<bool> crosses;              // per triangle, whether any other
    std::vector<std::array<int, 2>> which;  // the pairs, lower number first, in order
};

// Columns of `x` that are not finite make their triangles cross nothing.
Crossings count_crossings(const Faces& faces, In x);

// Only of pairs of triangles that `counts` says do.
Crossings count_crossings(const Faces& faces, In x, const std::function<bool(int, int)>& counts);

}  // namespace drape
