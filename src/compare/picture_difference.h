// How far two pictures of one size are apart, pixel by pixel.
#pragma once

#include <array>
#include <cstdint>

#include "base/image.h"

namespace drape {

struct PictureDifference {
    double mean_levels = 0;        // mean absolute difference of 8-bit levels
    double share_over = 0;         // of pixels that differ by more than 8 levels in any channel
    double share_off_edges = 0;    // of those among them that no edge that moved explains (edge_shift.h)
    double density = 0;            // share of such pixels in the window of 32 x 32 that has the most
    std::array<int, 2> densest{};  // that window's upper left corner; where there are several, the first
    std::array<std::int64_t, 256> histogram{};  // pixels by the levels that their worst channel differs
};

// The pictures must be of one size.
PictureDifference picture_difference(const Image& picture, const Image& reference);

}  // namespace drape
