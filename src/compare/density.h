// Where differing pixels are thick: a few hundred of them scattered over a picture are noise, in one place a
// change.
#pragma once

#include <cstdint>
#include <span>

namespace drape {

struct DensestWindow {
    double share = 0;  // of the window's pixels that are marked
    int x = 0, y = 0;  // its upper left corner
};

// The window of `side` x `side` pixels, or of what the picture has, with the most pixels that are marked with
// 1; the first in reading order where several have as many. `marked` has a byte for every pixel, row by row.
DensestWindow densest_window(std::span<const std::uint8_t> marked, int width, int height, int side);

}  // namespace drape
