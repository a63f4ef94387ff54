// The legend of the strain overlay, drawn into the finished picture.
#pragma once

#include "base/image.h"

namespace drape {

// A bar from -range to +range with ticks in per cent, in the lower right corner. Pictures too small to hold
// legible numbers (under 120 x 90) get none.
void draw_colour_bar(Image& image, double range);

}  // namespace drape
