#include "picture/lettering.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "picture/blend.h"
#include "picture/font.h"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
// old C inside
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_truetype.h>
#pragma GCC diagnostic pop

namespace drape {

namespace {

struct Face {
    stbtt_fontinfo info{};
    int capital = 1;  // height of an H [font units]

    Face() {
        stbtt_InitFont(&info, font_file().data(), 0);
        int left = 0, bottom = 0, right = 0;
        stbtt_GetCodepointBox(&info, 'H', &left, &bottom, &right, &capital);
    }
};

const Face& face() {
    static const Face the_one;
    return the_one;
}

constexpr int replacement = 0xFFFD;

// The character that `text` begins with, taken off it.
int next_character(std::string_view& text) {
    const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned lead = byte(0);
    const size_t length = lead < 0x80       ? 1
                          : lead >> 5 == 6  ? 2
                          : lead >> 4 == 14 ? 3
                          : lead >> 3 == 30 ? 4
                                            : 0;
    unsigned character = length > 1 ? lead & (0xFFU >> (length + 1)) : lead;
    for (size_t i = 1; i < length; ++i) {
        if (byte(i) >> 6 != 2) {
            text.remove_prefix(1);
            return replacement;
        }
        character = character << 6 | (byte(i) & 0x3F);
    }
    text.remove_prefix(std::max<size_t>(length, 1));
    return length > 0 ? static_cast<int>(character) : replacement;
}

// Tells `place(glyph, offset)` of every glyph and how far right of the first it stands; returns the width.
template <class Place>
float set_type(std::string_view text, float scale, Place&& place) {
    float at = 0;
    int before = 0;
    while (!text.empty()) {
        const int glyph = stbtt_FindGlyphIndex(&face().info, next_character(text));
        if (at > 0) at += scale * static_cast<float>(stbtt_GetGlyphKernAdvance(&face().info, before, glyph));
        int advance = 0, bearing = 0;
        stbtt_GetGlyphHMetrics(&face().info, glyph, &advance, &bearing);
        place(glyph, at);
        at += scale * static_cast<float>(advance);
        before = glyph;
    }
    return at;
}

float scale_of(float size) {
    return size / static_cast<float>(face().capital);
}

void draw_glyph(Image& image, int glyph, float x, float y, float scale, const Pen& pen) {
    const float column = std::floor(x), row = std::floor(y);
    int left = 0, top = 0, right = 0, bottom = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&face().info, glyph, scale, scale, x - column, y - row, &left, &top,
                                    &right, &bottom);
    const int width = right - left, height = bottom - top;
    if (width <= 0 || height <= 0) return;
    std::vector<unsigned char> cover(static_cast<size_t>(width) * static_cast<size_t>(height));
    stbtt_MakeGlyphBitmapSubpixel(&face().info, cover.data(), width, height, width, scale, scale, x - column,
                                  y - row, glyph);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const int to_x = static_cast<int>(column) + left + i, to_y = static_cast<int>(row) + top + j;
            if (to_x < 0 || to_y < 0 || to_x >= image.width || to_y >= image.height) continue;
            const auto at = static_cast<size_t>(j) * static_cast<size_t>(width) + static_cast<size_t>(i);
            blend(image.pixel(to_x, to_y), pen.colour, pen.opacity * static_cast<float>(cover[at]) / 255);
        }
}

}  // namespace

float text_width(std::string_view text, float size) {
    return set_type(text, scale_of(size), [](int, float) {});
}

void draw_text(Image& image, std::string_view text, float x, float y, const Pen& pen) {
    const float scale = scale_of(pen.size);
    set_type(text, scale,
             [&](int glyph, float offset) { draw_glyph(image, glyph, x + offset, y, scale, pen); });
}

}  // namespace drape
