#include "picture/resize.h"

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("a resized picture has the size asked for, and flat colours stay to the level", "[picture]") {
    Image image(64, 36);
    for (size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = static_cast<std::uint8_t>(40 + 80 * (i % 3));
    for (const auto& [width, height] : {std::pair{31, 17}, {128, 72}, {1, 1}, {64, 36}}) {
        const Image other = resized(image, width, height);
        REQUIRE(other.width == width);
        REQUIRE(other.height == height);
        for (size_t i = 0; i < other.rgb.size(); ++i) CHECK(other.rgb[i] == 40 + 80 * (i % 3));
    }
}

TEST_CASE("a fine pattern keeps its light, not its levels, where it becomes too fine to see", "[picture]") {
    Image image(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = (x + y) % 2 ? 255 : 0;
    const Image smaller = resized(image, 8, 8);
    // half the light of white is level 188 in sRGB; half its level is 128
    CHECK(std::abs(smaller.pixel(4, 4)[0] - 188) <= 1);
}
