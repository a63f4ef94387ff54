#include "compare/heat.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/assert.h"

namespace drape {

Image heat_map(const ErrorMap& map) {
    constexpr std::array<std::array<float, 3>, 5> stops{
        {{0, 0, 0}, {66, 10, 104}, {187, 55, 84}, {249, 142, 9}, {255, 244, 180}}};
    Image image(map.width, map.height);
    for (size_t i = 0; i < map.error.size(); ++i) {
        const float along = std::sqrt(std::clamp(map.error[i], 0.0F, 1.0F)) * (stops.size() - 1);
        const size_t stop = std::min(static_cast<size_t>(along), stops.size() - 2);
        const float part = along - static_cast<float>(stop);
        for (size_t c = 0; c < 3; ++c)
            image.rgb[3 * i + c] = static_cast<std::uint8_t>(
                std::lround(stops[stop][c] + part * (stops[stop + 1][c] - stops[stop][c])));
    }
    return image;
}

Image brightest(const Image& image, int factor) {
    DRAPE_ASSERT(factor > 0);
    Image smaller((image.width + factor - 1) / factor, (image.height + factor - 1) / factor);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* from = image.pixel(x, y);
            std::uint8_t* to = smaller.pixel(x / factor, y / factor);
            for (int c = 0; c < 3; ++c) to[c] = std::max(to[c], from[c]);
        }
    }
    return smaller;
}

}  // namespace drape
