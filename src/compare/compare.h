// Two results held against each other: pictures, position caches, or folders of both.
#pragma once

#include <string>
#include <vector>

#include "compare/compared.h"
#include "compare/limits.h"

namespace drape {

// What is asked of a comparison beside what compare.toml says.
struct Asked {
    Limits limits = {};                  // over those of compare.toml, which are over the usual ones
    std::vector<Rectangle> ignore = {};  // and those of compare.toml
    bool perceptual = false;             // SSIM and FLIP, where pictures differ
    bool hausdorff = false;              // of caches
};

// `result` and `reference` are two pictures (.png), two caches (.pc2, .mdd, .glb), or two folders, of which
// frames (frame_*.png) and caches are compared by name. What only the reference has is missing, what only the
// result has is added. The compare.toml beside the references is read (limits.h). Throws Error for what is
// neither, cannot be read, or for folders without anything to compare.
Comparison compare(const std::string& result, const std::string& reference, const Asked& asked);

// The paths of a compared file on both sides, and the rectangles that are not looked at in it.
struct ComparedPaths {
    std::string result, reference;
    std::vector<Rectangle> ignore;
};
ComparedPaths paths_of(const Compared& file, const std::string& result, const std::string& reference,
                       const Asked& asked);

}  // namespace drape
