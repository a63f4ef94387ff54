// Where a buckled sheet folds, by mesh pattern: a disc is no reason to fold in any direction, its mesh may
// be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drape {

inline constexpr int fold_bins = 12;  // of directions, from 0 to 180 degrees from x towards z

struct FoldRose {
    std::string pattern;
    std::vector<double> share;  // of the folding in each bin, over the mean of all; the first is round 0
    double along_lines = 0;     // share of it within 15 degrees of one of the mesh's lines, over an even one
    double turn_deg = 0;        // of a fold's direction from a vertex to the next, on average
    double most() const;        // of the bins
    double most_deg() const;    // its middle
};

// A disc, its border held and moved inwards by a few per cent, comes to rest out of its plane; `starts` of
// them, which small noise tells apart. A vertex counts with its sharpest curvature, in the direction of the
// fold line that has it.
FoldRose fold_directions(std::string_view pattern, int divisions, int starts);

}  // namespace drape
