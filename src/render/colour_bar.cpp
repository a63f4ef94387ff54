#include "render/colour_bar.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "picture/lettering.h"

namespace drape {

namespace {

void paint(Image& image, int x, int y, const Colour& colour) {
    for (size_t c = 0; c < 3; ++c)
        image.pixel(x, y)[c] = static_cast<std::uint8_t>(std::lround(255 * colour[c]));
}

}  // namespace

void draw_colour_bar(Image& image, const ColourScale& scale) {
    if (image.width < 120 || image.height < 90) return;
    const float size = std::max(0.019f * static_cast<float>(image.height), 6.0f);
    const int margin = static_cast<int>(2.2f * size), thick = std::max(static_cast<int>(0.8f * size), 4);
    const int length = std::max(image.width / 5, 60), left = image.width - margin - length;
    const int top = image.height - margin - thick - static_cast<int>(1.6f * size);
    for (int y = top - 1; y <= top + thick; ++y)
        for (int x = left - 1; x <= left + length; ++x) {
            const bool rim = y < top || y == top + thick || x < left || x == left + length;
            const float t = 2 * (static_cast<float>(x - left) + 0.5f) / static_cast<float>(length) - 1;
            paint(image, x, y, rim ? Colour{0.16f, 0.18f, 0.22f} : scale.colour(t));
        }

    const Pen pen{size, {0.10f, 0.12f, 0.16f}, 0.92f};
    const float right_end = static_cast<float>(image.width) - 0.5f * size;  // of the last label
    const float below = static_cast<float>(top + thick) + 1.7f * size;
    for (const double part : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        const int at = left + static_cast<int>(std::lround((part + 1) / 2 * (length - 1)));
        for (int y = top + thick; y < top + thick + static_cast<int>(0.4f * size); ++y)
            paint(image, at, y, {0.16f, 0.18f, 0.22f});
        if (part == 0.5 || part == -0.5) continue;
        const std::string& text = scale.label[static_cast<size_t>(std::lround(part + 1))];
        const float wide = text_width(text, size);
        draw_text(image, text, std::min(static_cast<float>(at) - wide / 2, right_end - wide), below, pen);
    }
    draw_text(image, scale.title, static_cast<float>(left), static_cast<float>(top) - 0.7f * size, pen);
}

}  // namespace drape
