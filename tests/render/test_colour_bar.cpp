#include "render/colour_bar.h"

#include <catch2/catch.hpp>

#include "render/colour_map.h"
#include "render/drawables.h"

using namespace drape;

namespace {

ColourScale scale(const char* most) {
    return {"strain", {"-1 %", "0", most}, diverging_colour};
}

Image grey(int width, int height) {
    Image image(width, height);
    std::fill(image.rgb.begin(), image.rgb.end(), std::uint8_t{200});
    return image;
}

}  // namespace

TEST_CASE("the colour bar runs from blue over light grey to red, with dark lettering under it", "[render]") {
    Image image = grey(640, 360);
    draw_colour_bar(image, scale("+1 %"));
    int blue = 0, red = 0, dark = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* p = image.pixel(x, y);
            if (p[2] > p[0] + 80) blue += x > 440 && x < 560;
            if (p[0] > p[2] + 80) red += x > 560;
            dark += p[0] < 90 && p[1] < 90 && p[2] < 90;
        }
    CHECK(blue > 50);
    CHECK(red > 50);
    CHECK(dark > 100);
    CHECK(int(image.pixel(10, 10)[0]) == 200);  // the rest of the picture is left alone
}

TEST_CASE("another label is written beside the same bar", "[render]") {
    Image five = grey(640, 360), ten = grey(640, 360);
    draw_colour_bar(five, scale("+5 %"));
    draw_colour_bar(ten, scale("+10 %"));
    CHECK(five.rgb != ten.rgb);
}

TEST_CASE("a picture too small for legible numbers gets no bar", "[render]") {
    Image image = grey(64, 48);
    draw_colour_bar(image, scale("+1 %"));
    CHECK(image.rgb == grey(64, 48).rgb);
}

TEST_CASE("strain colours are lightest and least coloured in the middle and clamp at the ends", "[render]") {
    const auto chroma = [](const Colour& c) {
        return *std::max_element(c.begin(), c.end()) - *std::min_element(c.begin(), c.end());
    };
    CHECK(chroma(diverging_colour(0)) < 0.03f);
    CHECK(chroma(diverging_colour(0.5f)) > 0.2f);
    CHECK(chroma(diverging_colour(-0.5f)) > 0.2f);
    CHECK(diverging_colour(7) == diverging_colour(1));
    CHECK(diverging_colour(1)[0] > diverging_colour(1)[2]);
    CHECK(diverging_colour(-1)[2] > diverging_colour(-1)[0]);
}

TEST_CASE("error colours grow darker all the way, and clamp at the ends", "[render]") {
    const auto light = [](float t) {
        return linear_light(rising_colour(t)).dot(Eigen::Vector3f(0.21f, 0.72f, 0.07f));
    };
    for (float t = -1; t < 0.95f; t += 0.1f) CHECK(light(t) > light(t + 0.1f));
    CHECK(rising_colour(-7) == rising_colour(-1));
    CHECK(rising_colour(7) == rising_colour(1));
}
