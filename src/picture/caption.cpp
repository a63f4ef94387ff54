#include "picture/caption.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "picture/blend.h"
#include "picture/lettering.h"

namespace drape {

namespace {

// What is never broken, with the sign that parts it from what stands before it on the same line.
struct Piece {
    std::string text;
    std::string_view sign;
    float opacity;
};

struct Placed {
    const Piece* piece;
    int line;
    float x;  // from the lines' left end
    bool first_of_line;
};

struct Layout {
    std::vector<Placed> placed;
    int lines = 0;
    float width = 0;
};

constexpr std::string_view between_words = " ", between_facts = "  ·  ";

std::vector<Piece> pieces_of(const Caption& caption) {
    std::vector<Piece> pieces;
    std::istringstream words(caption.title);
    for (std::string word; words >> word;) pieces.push_back({word, between_words, 1});
    for (const std::string& fact : caption.facts) pieces.push_back({fact, between_facts, 0.78f});
    return pieces;
}

Layout lay_out(const std::vector<Piece>& pieces, float size, float most) {
    Layout layout;
    float x = 0;
    for (const Piece& piece : pieces) {
        const float width = text_width(piece.text, size), sign = text_width(piece.sign, size);
        const bool first = layout.lines == 0 || x + sign + width > most;
        if (first) ++layout.lines;
        x = first ? 0 : x + sign;
        layout.placed.push_back({&piece, layout.lines - 1, x, first});
        x += width;
        layout.width = std::max(layout.width, x);
    }
    return layout;
}

// How much of the pixel at (x, y) a rectangle with round corners covers.
float cover_of(float x, float y, float left, float top, float right, float bottom, float radius) {
    const float dx = std::max({left + radius - x, x - right + radius, 0.0f});
    const float dy = std::max({top + radius - y, y - bottom + radius, 0.0f});
    return std::clamp(radius + 0.5f - std::hypot(dx, dy), 0.0f, 1.0f);
}

void darken(Image& image, float left, float top, float right, float bottom, float radius) {
    for (int y = std::max(0, static_cast<int>(top) - 1);
         y < std::min(image.height, static_cast<int>(bottom) + 2); ++y)
        for (int x = std::max(0, static_cast<int>(left) - 1);
             x < std::min(image.width, static_cast<int>(right) + 2); ++x)
            blend(image.pixel(x, y), {0.06f, 0.07f, 0.09f},
                  0.62f * cover_of(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, left, top,
                                   right, bottom, radius));
}

}  // namespace

void draw_caption(Image& image, const Caption& caption, Corner corner) {
    if (image.width < 120 || image.height < 90) return;
    const std::vector<Piece> pieces = pieces_of(caption);
    if (pieces.empty()) return;
    const float size = std::max(std::round(0.02f * static_cast<float>(image.height)), 7.0f);
    const float margin = std::round(1.2f * size), padding = std::round(0.9f * size), line = 2.1f * size;
    const Layout layout = lay_out(pieces, size, static_cast<float>(image.width) - 2 * (margin + padding));

    const float height = 2 * padding + size + line * static_cast<float>(layout.lines - 1);
    const float top =
        corner == Corner::top_left ? margin : static_cast<float>(image.height) - margin - height;
    darken(image, margin, top, margin + 2 * padding + layout.width, top + height, 0.6f * size);
    for (const Placed& placed : layout.placed) {
        const Pen pen{size, {1, 1, 1}, placed.piece->opacity};
        const float x = margin + padding + placed.x;
        const float y = top + padding + size + line * static_cast<float>(placed.line);
        draw_text(image, placed.piece->text, x, y, pen);
        if (!placed.first_of_line)
            draw_text(image, placed.piece->sign, x - text_width(placed.piece->sign, size), y, pen);
    }
}

}  // namespace drape
