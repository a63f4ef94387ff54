#include "picture/lettering.h"

#include <catch2/catch.hpp>

using namespace drape;

namespace {

Image grey(int width, int height) {
    Image image(width, height);
    std::fill(image.rgb.begin(), image.rgb.end(), std::uint8_t{200});
    return image;
}

struct Ink {
    int left = 1000, top = 1000, right = -1, bottom = -1, pixels = 0;
};

Ink ink_of(const Image& image) {
    Ink ink;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (image.pixel(x, y)[0] < 120) {
                ink.left = std::min(ink.left, x);
                ink.right = std::max(ink.right, x);
                ink.top = std::min(ink.top, y);
                ink.bottom = std::max(ink.bottom, y);
                ++ink.pixels;
            }
    return ink;
}

Ink ink_of(std::string_view text, float size = 16) {
    Image image = grey(80, 60);
    draw_text(image, text, 20, 40, {size, {0, 0, 0}, 1});
    return ink_of(image);
}

}  // namespace

TEST_CASE("every character the pictures need leaves ink, and only where it stands", "[picture]") {
    for (char character = '!'; character <= '~'; ++character) {
        const std::string_view text(&character, 1);
        CAPTURE(text);
        const Ink ink = ink_of(text);
        CHECK(ink.pixels > 1);
        CHECK(ink.left >= 18);
        CHECK(static_cast<float>(ink.right) <= 22 + text_width(text, 16));
        CHECK(ink.top >= 40 - 21);
        CHECK(ink.bottom <= 40 + 6);
    }
}

TEST_CASE("a capital is as high as the pen says, and stands on the line", "[picture]") {
    for (const float size : {10.0f, 16.0f, 24.0f}) {
        const Ink ink = ink_of("H", size);
        CHECK(ink.bottom == 39);
        CHECK(ink.bottom - ink.top + 1 == int(size));
    }
}

TEST_CASE("text is UTF-8; what is none is set as the font's box, and never read past its end", "[picture]") {
    CHECK(text_width("µ", 16) == text_width("\xc2\xb5", 16));
    CHECK(ink_of("·").pixels < ink_of("×").pixels);
    for (const std::string_view broken : {"\xc2", "\xff", "\xe2\x82", "\x80", "\xf0\x9f"}) {
        CHECK(text_width(broken, 16) > 0);
        CHECK(ink_of(broken).pixels > 0);
    }
    CHECK(text_width("", 16) == 0);
}

TEST_CASE("text that leaves the picture is cut off at its border", "[picture]") {
    Image image = grey(20, 12);
    draw_text(image, "much too long", -6, 4, {16, {0, 0, 0}, 1});
    CHECK(ink_of(image).pixels > 10);
    Image none = grey(20, 12);
    draw_text(none, "far away", 500, -300, {16, {0, 0, 0}, 1});
    CHECK(none.rgb == grey(20, 12).rgb);
}
