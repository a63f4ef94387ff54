// One channel of a part of a picture, and separable filters over it.
#pragma once

#include <span>
#include <vector>

#include "compare/tiles.h"

namespace drape {

// A tile's pixels and `margin` more on every side.
struct Plane {
    int width = 0, height = 0;  // of the tile
    int margin = 0;
    std::vector<float> values;  // (width + 2 margin) x (height + 2 margin), row by row

    Plane() = default;
    Plane(int w, int h, int m)
        : width(w),
          height(h),
          margin(m),
          values(static_cast<size_t>(w + 2 * m) * static_cast<size_t>(h + 2 * m)) {}
    int stride() const { return width + 2 * margin; }
    // the pixel (0, y) of the tile; y may be in the margin
    const float* row(int y) const {
        return values.data() + static_cast<size_t>(y + margin) * static_cast<size_t>(stride()) + margin;
    }
    float* row(int y) { return const_cast<float*>(std::as_const(*this).row(y)); }
};

// The plane weighed by across[i] at column x + i - r and down[j] at row y + j - s, where r and s are half of
// their odd lengths and at most the margin. The result has no margin.
Plane filtered(const Plane& plane, std::span<const float> across, std::span<const float> down);

// The weights exp(-x^2 / (2 sigma^2)) at the whole numbers from -radius to radius, with a sum of 1.
std::vector<float> gaussian(double sigma, int radius);

}  // namespace drape
