// Small lettering for pictures: strokes with round ends, drawn at any size.
#pragma once

#include <string_view>

#include "base/image.h"
#include "render/picture.h"

namespace drape {

struct Pen {
    float size = 12;  // height of a capital [pixels]
    Colour colour{1, 1, 1};
    float opacity = 1;
};

// Width of `text` [pixels]. Knows digits, space and + - . % and the lower-case letters of "strain" and "error
// mm".
float text_width(std::string_view text, float size);

// Draws with the lower left corner of the first character at (x, y), y growing downwards.
void draw_text(Image& image, std::string_view text, float x, float y, const Pen& pen);

}  // namespace drape
