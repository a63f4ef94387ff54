// The legend of a tint, drawn into the finished picture.
#pragma once

#include "base/image.h"
#include "render/picture.h"

namespace drape {

// A bar with the scale's title and labels in the lower right corner. Pictures too small to hold legible
// numbers (under 120 x 90) get none.
void draw_colour_bar(Image& image, const ColourScale& scale);

}  // namespace drape
