// Colours for what a scene gives no colour of its own.
#pragma once

#include "base/colour.h"

namespace drape {

struct ClothPalette {
    Colour front, back, stripe;
};

// Cloth 0 is red with a cream lining, then blue, mustard, sage, plum, teal; round again after that.
ClothPalette cloth_palette(int cloth);

}  // namespace drape
