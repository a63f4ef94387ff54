// Two results held against each other: pictures, position caches, or folders of both.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/cache_difference.h"
#include "compare/picture_difference.h"

namespace drape {

// What passes for the same. Pictures: the noise of other processors is up to 5 pixels of 921600 over 8 levels
// and a mean of 4e-4 levels, a bump of 1 mm 52 pixels and 3.5e-3, so the bounds lie between. Positions: ten
// roundings of a cache's single precision at a metre.
struct Gate {
    double share_over = 2e-5;   // of pixels that differ by more than 8 levels
    double mean_levels = 2e-3;  // mean absolute difference
    double rms_m = 1e-6;        // of a sample's positions [m]
};

enum class Verdict { identical, within, different, missing, added };

std::string_view verdict_name(Verdict verdict);

struct Compared {
    std::string name;  // of the file
    Verdict verdict = Verdict::identical;
    std::string why;                                // it is different; else empty
    std::optional<PictureDifference> picture = {};  // where the pixels differ
    std::optional<CacheDifference> cache = {};      // where the positions do
};

struct Comparison {
    std::vector<Compared> files;  // by name

    int count(Verdict verdict) const;
    bool passed() const;  // every file is identical or within the gate
};

// `result` and `reference` are two pictures (.png), two caches (.pc2, .mdd), or two folders, of which frames
// (frame_*.png) and caches are compared by name. What only the reference has is missing, what only the result
// has is added. Throws Error for what is neither, cannot be read, or for folders without anything to compare.
Comparison compare(const std::string& result, const std::string& reference, const Gate& gate);

// What the pictures and caches of a comparison say together: whether the simulation or only its look changed;
// empty where they do not tell.
std::string cause_of(const Comparison& comparison);

// Stable keys: passed, cause, files [{name, verdict, why, picture {...}, cache {...}}].
std::string comparison_json(const Comparison& comparison);

}  // namespace drape
