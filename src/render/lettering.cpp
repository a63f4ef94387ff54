#include "render/lettering.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace drape {

namespace {

// A character as strokes on a grid 4 wide and 6 high, y upwards: points "xy" joined by lines, strokes apart
// by a space.
struct Glyph {
    char character;
    float advance;  // [grid units]
    std::string_view strokes;
};

constexpr Glyph glyphs[] = {
    {'0', 5.6f, "103041453616050110"},
    {'1', 4.6f, "042620"},
    {'2', 5.6f, "05163645440040"},
    {'3', 5.6f, "05163645443313 334241301001"},
    {'4', 5.6f, "30360242"},
    {'5', 5.6f, "460603334241301001"},
    {'6', 5.6f, "4536160501103041423303"},
    {'7', 5.6f, "064610"},
    {'8', 5.6f, "1304051636454433130201103041423313"},
    {'9', 5.6f, "0110304145361605041343"},
    {'+', 6.0f, "0343 2125"},
    {'-', 5.0f, "0333"},
    {'.', 2.4f, "0000"},
    {'%', 6.0f, "0046 0406161404 3032424030"},
    {'s', 4.8f, "3414031222312000"},
    {'t', 4.4f, "16112030 0424"},
    {'r', 4.0f, "0004 02142434"},
    {'a', 4.8f, "3430 3324140301102031"},
    {'i', 2.2f, "0004 0606"},
    {'n', 5.0f, "0004 0314243330"},
    {'e', 4.8f, "0232332414030110203031"},
    {'o', 5.0f, "100103142433312010"},
    {'m', 6.2f, "0004 0314242320 2334444340"},
    {' ', 3.0f, ""},
};

struct Stroke {
    float ax, ay, bx, by;
};

const Glyph& glyph_of(char character) {
    for (const Glyph& glyph : glyphs)
        if (glyph.character == character) return glyph;
    return std::end(glyphs)[-1];
}

std::vector<Stroke> strokes_of(std::string_view text, float x, float y, float unit) {
    std::vector<Stroke> strokes;
    for (const char character : text) {
        const Glyph& glyph = glyph_of(character);
        const auto place = [&](size_t i) {
            return std::pair{x + unit * static_cast<float>(glyph.strokes[i] - '0'),
                             y - unit * static_cast<float>(glyph.strokes[i + 1] - '0')};
        };
        for (size_t i = 0; i + 3 < glyph.strokes.size(); i += 2) {
            if (glyph.strokes[i + 2] == ' ') {
                ++i;  // the next stroke starts behind the space
                continue;
            }
            const auto [ax, ay] = place(i);
            const auto [bx, by] = place(i + 2);
            strokes.push_back({ax, ay, bx, by});
        }
        x += unit * glyph.advance;
    }
    return strokes;
}

float distance_to(const Stroke& s, float x, float y) {
    const float dx = s.bx - s.ax, dy = s.by - s.ay, length2 = dx * dx + dy * dy;
    const float t =
        length2 > 0 ? std::clamp(((x - s.ax) * dx + (y - s.ay) * dy) / length2, 0.0f, 1.0f) : 0.0f;
    return std::hypot(x - s.ax - t * dx, y - s.ay - t * dy);
}

}  // namespace

float text_width(std::string_view text, float size) {
    float width = 0;
    for (const char character : text) width += glyph_of(character).advance;
    return width * size / 6;
}

void draw_text(Image& image, std::string_view text, float x, float y, const Pen& pen) {
    const std::vector<Stroke> strokes = strokes_of(text, x, y, pen.size / 6);
    const float half_width = std::max(0.065f * pen.size, 0.5f);
    const int left = std::max(static_cast<int>(x - 2), 0),
              top = std::max(static_cast<int>(y - pen.size - 2), 0);
    const int right = std::min(static_cast<int>(x + text_width(text, pen.size) + 3), image.width);
    const int bottom = std::min(static_cast<int>(y + 3), image.height);
    for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column) {
            float nearest = 1e9f;
            for (const Stroke& stroke : strokes)
                nearest = std::min(nearest, distance_to(stroke, static_cast<float>(column) + 0.5f,
                                                        static_cast<float>(row) + 0.5f));
            const float cover = pen.opacity * std::clamp(half_width + 0.5f - nearest, 0.0f, 1.0f);
            std::uint8_t* pixel = image.pixel(column, row);
            for (size_t c = 0; c < 3; ++c)
                pixel[c] = static_cast<std::uint8_t>(
                    std::lround(static_cast<float>(pixel[c]) * (1 - cover) + 255 * pen.colour[c] * cover));
        }
}

}  // namespace drape
