#include "compare/ssim.h"

#include <algorithm>

#include "base/assert.h"
#include "base/wide.h"
#include "compare/plane.h"

namespace drape {

namespace {

constexpr int radius = 5;  // of the window [pixels]

Plane grey(const Image& image, const Tile& tile) {
    Plane plane(tile.width(), tile.height(), radius);
    for (int y = -radius; y < plane.height + radius; ++y) {
        float* row = plane.row(y);
        const int v = std::clamp(tile.top + y, 0, image.height - 1);
        for (int x = -radius; x < plane.width + radius; ++x) {
            const std::uint8_t* rgb = image.pixel(std::clamp(tile.left + x, 0, image.width - 1), v);
            row[x] = 0.299F * rgb[0] + 0.587F * rgb[1] + 0.114F * rgb[2];
        }
    }
    return plane;
}

DRAPE_WIDE void multiply(const float* a, const float* b, float* to, int count) {
    for (int i = 0; i < count; ++i) to[i] = a[i] * b[i];
}

Plane product(const Plane& a, const Plane& b) {
    Plane plane(a.width, a.height, a.margin);
    multiply(a.values.data(), b.values.data(), plane.values.data(), static_cast<int>(plane.values.size()));
    return plane;
}

double sum_over(const Image& picture, const Image& reference, const Tile& tile) {
    static const std::vector<float> window = gaussian(1.5, radius);
    constexpr float c1 = 0.01F * 255 * 0.01F * 255, c2 = 0.03F * 255 * 0.03F * 255;
    const Plane x = grey(picture, tile), y = grey(reference, tile);
    const auto mean = [](const Plane& plane) { return filtered(plane, window, window); };
    const Plane mx = mean(x), my = mean(y), xx = mean(product(x, x)), yy = mean(product(y, y)),
                xy = mean(product(x, y));
    double sum = 0;
    for (size_t i = 0; i < mx.values.size(); ++i) {
        const float a = mx.values[i], b = my.values[i];
        const float spread = (xx.values[i] - a * a) + (yy.values[i] - b * b);
        sum += (2 * a * b + c1) * (2 * (xy.values[i] - a * b) + c2) / ((a * a + b * b + c1) * (spread + c2));
    }
    return sum;
}

}  // namespace

double ssim(const Image& picture, const Image& reference) {
    DRAPE_ASSERT(picture.width == reference.width && picture.height == reference.height);
    const double pixels = static_cast<double>(picture.width) * picture.height;
    double lost = 0;
    for (const Tile& tile : changed_tiles(picture, reference, radius))
        lost += static_cast<double>(tile.width()) * tile.height() - sum_over(picture, reference, tile);
    return pixels > 0 ? 1 - lost / pixels : 1;
}

}  // namespace drape
