#include "picture/panes.h"

#include <array>

#include <catch2/catch.hpp>

using namespace drape;

namespace {

Image filled(int width, int height, std::uint8_t level) {
    Image image(width, height);
    std::fill(image.rgb.begin(), image.rgb.end(), level);
    return image;
}

}  // namespace

TEST_CASE("pictures stand from left to right, then in the next row, with a line between", "[picture]") {
    const std::array pictures{filled(10, 6, 50), filled(10, 6, 100), filled(10, 6, 150)};
    const Image row = beside(pictures, 3);
    CHECK(row.width == 3 * 10 + 2 * 2);
    CHECK(row.height == 6);
    CHECK(int(row.pixel(0, 0)[0]) == 50);
    CHECK(int(row.pixel(9, 5)[2]) == 50);
    CHECK(int(row.pixel(10, 3)[0]) == 32);
    CHECK(int(row.pixel(12, 0)[0]) == 100);
    CHECK(int(row.pixel(33, 5)[0]) == 150);

    const Image grid = beside(pictures, 2);
    CHECK(grid.width == 22);
    CHECK(grid.height == 14);
    CHECK(int(grid.pixel(0, 8)[0]) == 150);
    CHECK(int(grid.pixel(21, 13)[0]) == 32);  // no fourth picture

    CHECK(beside(pictures, 9).width == row.width);
    CHECK(beside(std::span(pictures).first(1), 4).rgb == pictures[0].rgb);
}

TEST_CASE("a difference is black where pictures are alike, and grows with either sign until it is clamped",
          "[picture]") {
    Image picture = filled(4, 1, 100);
    const Image reference = filled(4, 1, 100);
    picture.pixel(1, 0)[0] = 103;
    picture.pixel(2, 0)[1] = 97;
    picture.pixel(3, 0)[2] = 200;
    const Image difference = amplified_difference(picture, reference, 16);
    const std::vector<std::uint8_t> expected{0, 0, 0, 48, 0, 0, 0, 48, 0, 0, 0, 255};
    CHECK(difference.rgb == expected);
}

TEST_CASE("a picture is extended by its last column and row", "[picture]") {
    Image image = filled(3, 3, 10);
    image.pixel(2, 0)[0] = 77;
    image.pixel(0, 2)[1] = 88;
    image.pixel(2, 2)[2] = 99;
    const Image larger = extended(image, 4, 4);
    REQUIRE(larger.width == 4);
    REQUIRE(larger.height == 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            for (int c = 0; c < 3; ++c)
                CHECK(larger.pixel(x, y)[c] == image.pixel(std::min(x, 2), std::min(y, 2))[c]);
}
