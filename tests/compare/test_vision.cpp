#include "compare/vision.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "compare/pictures.h"

using namespace drape;
using namespace drape::test;

namespace {

struct Triple {
    float y, cx, cz;
};

Triple first(const Opponent& colours) {
    return {colours.y.values.at(0), colours.cx.values.at(0), colours.cz.values.at(0)};
}

Opponent of_pixel(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    Image image(1, 1);
    image.rgb = {red, green, blue};
    return opponent_colours(image, {0, 0, 1, 1}, 0);
}

}  // namespace

TEST_CASE("greys have no hue and black and white are the ends of lightness", "[compare]") {
    for (const int level : {0, 40, 128, 255}) {
        CAPTURE(level);
        const auto v = static_cast<std::uint8_t>(level);
        Opponent colours = of_pixel(v, v, v);
        CHECK(first(colours).cx == Approx(0).margin(1e-3));
        CHECK(first(colours).cz == Approx(0).margin(1e-3));
        to_hunt_lab(colours);
        if (level == 0) CHECK(first(colours).y == Approx(0).margin(1e-3));
        if (level == 255) CHECK(first(colours).y == Approx(100));
    }
}

TEST_CASE("a colour's L*a*b* is CIE's with the Hunt effect on a and b", "[compare]") {
    Opponent red = of_pixel(255, 0, 0);
    to_hunt_lab(red);
    // CIE L*a*b* of sRGB's red under D65: 53.24, 80.09, 67.20
    CHECK(first(red).y == Approx(53.24).margin(0.02));
    CHECK(first(red).cx == Approx(0.5324 * 80.09).margin(0.05));
    CHECK(first(red).cz == Approx(0.5324 * 67.20).margin(0.05));
}

TEST_CASE("beyond the border the outermost pixels go on", "[compare]") {
    const Image image = random_picture(4, 3, 5);
    const Opponent colours = opponent_colours(image, {0, 0, 4, 3}, 2);
    CHECK(colours.y.row(-2)[-2] == colours.y.row(0)[0]);
    CHECK(colours.cz.row(4)[5] == colours.cz.row(2)[3]);
    CHECK(colours.cx.row(1)[-1] == colours.cx.row(1)[0]);
}
