// A colour laid over a pixel.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/colour.h"

namespace drape {

// `cover` 0 leaves the pixel, 1 replaces it.
inline void blend(std::uint8_t* pixel, const Colour& colour, float cover) {
    for (std::size_t c = 0; c < 3; ++c)
        pixel[c] = static_cast<std::uint8_t>(
            std::lround(static_cast<float>(pixel[c]) * (1 - cover) + 255 * colour[c] * cover));
}

}  // namespace drape
