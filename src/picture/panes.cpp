#include "picture/panes.h"

#include <algorithm>
#include <cstdlib>

#include "base/assert.h"

namespace drape {

Image beside(std::span<const Image> pictures, int columns) {
    DRAPE_ASSERT(!pictures.empty() && columns > 0);
    constexpr std::uint8_t line = 32;
    const Image& first = pictures.front();
    const int across = std::min(columns, static_cast<int>(pictures.size()));
    const int down = (static_cast<int>(pictures.size()) + across - 1) / across;
    const int gap = std::max(2, first.height / 180);
    Image all(across * (first.width + gap) - gap, down * (first.height + gap) - gap);
    std::fill(all.rgb.begin(), all.rgb.end(), line);
    for (size_t i = 0; i < pictures.size(); ++i) {
        const Image& picture = pictures[i];
        DRAPE_ASSERT(picture.width == first.width && picture.height == first.height);
        const int left = static_cast<int>(i) % across * (first.width + gap);
        const int top = static_cast<int>(i) / across * (first.height + gap);
        for (int y = 0; y < picture.height; ++y)
            std::copy_n(picture.pixel(0, y), 3 * picture.width, all.pixel(left, top + y));
    }
    return all;
}

Image amplified_difference(const Image& picture, const Image& reference, int gain) {
    DRAPE_ASSERT(picture.width == reference.width && picture.height == reference.height);
    Image difference(picture.width, picture.height);
    for (size_t i = 0; i < difference.rgb.size(); ++i)
        difference.rgb[i] = static_cast<std::uint8_t>(
            std::min(gain * std::abs(int{picture.rgb[i]} - int{reference.rgb[i]}), 255));
    return difference;
}

Image extended(const Image& image, int width, int height) {
    Image larger(std::max(width, image.width), std::max(height, image.height));
    for (int y = 0; y < larger.height; ++y) {
        const int from = std::min(y, image.height - 1);
        std::copy_n(image.pixel(0, from), 3 * image.width, larger.pixel(0, y));
        for (int x = image.width; x < larger.width; ++x)
            std::copy_n(image.pixel(image.width - 1, from), 3, larger.pixel(x, y));
    }
    return larger;
}

}  // namespace drape
