// Lettering in pictures, in Open Sans, which is part of the program: the same pixels wherever it runs.
#pragma once

#include <string_view>

#include "base/colour.h"
#include "base/image.h"

namespace drape {

struct Pen {
    float size = 12;  // height of a capital [pixels]
    Colour colour{1, 1, 1};
    float opacity = 1;
};

// Width of `text` [pixels], which is UTF-8; what is none, and what the font lacks, shows as the font's box.
float text_width(std::string_view text, float size);

// Draws with the left end of the base line at (x, y), y growing downwards; what falls outside is cut off.
void draw_text(Image& image, std::string_view text, float x, float y, const Pen& pen);

}  // namespace drape
