// The frames of a comparison's page, and their pictures.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "compare/compare.h"

namespace drape {

// A frame that the page shows with its pictures.
struct ShownFrame {
    size_t file = 0;     // of Comparison::files
    bool small = false;  // reduced to about 480 pixels across, so that the page stays light
    std::string id() const { return cat("f", file); }
};

// What failed, by name, then the worst of what passed. The first that failed and the worst are of full size,
// the twelve next worst small; of what passed without being identical the two worst are shown, small. The
// rest is left out.
std::vector<ShownFrame> shown_frames(const Comparison& comparison);

// The pictures of a frame as <figure>s with everything in them: result, reference, what they differ in times
// 16, and FLIP's map. Of a frame that one side lacks, or of two sizes, what there is. Fills in what an eye
// would say.
std::string frame_figures(Compared& file, const ComparedPaths& paths, bool small);

}  // namespace drape
