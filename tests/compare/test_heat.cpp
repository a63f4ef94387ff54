#include "compare/heat.h"

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("a map grows brighter with the error from black on", "[compare]") {
    const Image image = heat_map({5, 1, {0, 0.01F, 0.1F, 0.5F, 1}});
    CHECK(image.rgb[0] + image.rgb[1] + image.rgb[2] == 0);
    for (int x = 1; x < 5; ++x) {
        const std::uint8_t *now = image.pixel(x, 0), *before = image.pixel(x - 1, 0);
        CHECK(now[0] + now[1] + now[2] > before[0] + before[1] + before[2]);
    }
    CHECK(image.pixel(4, 0)[0] == 255);
}

TEST_CASE("a single spot stays as bright as it was when a picture is reduced by the brightest", "[compare]") {
    Image image(11, 7);
    image.pixel(10, 6)[1] = 200;
    image.pixel(3, 2)[0] = 90;
    const Image smaller = brightest(image, 4);
    CHECK(smaller.width == 3);
    CHECK(smaller.height == 2);
    CHECK(smaller.pixel(2, 1)[1] == 200);
    CHECK(smaller.pixel(0, 0)[0] == 90);
    CHECK(smaller.pixel(1, 0)[0] == 0);
    CHECK(brightest(image, 1).rgb == image.rgb);
}
