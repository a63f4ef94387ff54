// Pictures of where two others differ.
#pragma once

#include "base/image.h"
#include "compare/flip.h"

namespace drape {

// Black where an eye notices nothing, over violet, red and orange to pale yellow at an error of 1; as far
// along as the root of the error, so that small ones show.
Image heat_map(const ErrorMap& map);

// Smaller by a whole factor; each pixel is the brightest, channel by channel, of those it stands for, so that
// no spot gets lost. Rows and columns left over at the end have pixels of their own.
Image brightest(const Image& image, int factor);

}  // namespace drape
