// The parts of two pictures that a measure with a window need look at: where nothing differs near, it has
// nothing to say.
#pragma once

#include <vector>

#include "base/image.h"

namespace drape {

// Pixels from (left, top) up to and without (right, bottom).
struct Tile {
    int left = 0, top = 0, right = 0, bottom = 0;

    int width() const { return right - left; }
    int height() const { return bottom - top; }
};

// Tiles of 64 x 64 pixels, row by row, with a pixel that differs in them or up to `reach` pixels beside them.
// The pictures must be of one size.
std::vector<Tile> changed_tiles(const Image& picture, const Image& reference, int reach);

}  // namespace drape
