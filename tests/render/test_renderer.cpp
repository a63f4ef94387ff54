#include "render/colour_map.h"
#include "render/renderer.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "support/small_picture.h"

using namespace drape;

namespace {

bool is_red(const std::uint8_t* p) {
    return p[0] > 120 && p[0] > 2 * p[1] && p[0] > 2 * p[2];
}
bool is_grey(const std::uint8_t* p) {
    return std::abs(p[0] - p[2]) < 40 && std::abs(p[0] - p[1]) < 30;
}

}  // namespace

TEST_CASE("a small picture shows red cloth, a grey ball, lit and shaded ground and a dark backdrop",
          "[render]") {
    const Image image = SmallPicture().draw();
    REQUIRE(image.width == 320);
    REQUIRE(image.height == 180);
    int red = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) red += is_red(image.pixel(x, y));
    CHECK(red > 4000);  // measured: about 8000
    CHECK(red < 16000);
    CHECK(is_red(image.pixel(160, 80)));    // the middle of the cloth
    CHECK(is_grey(image.pixel(140, 135)));  // the ball under its hem
    const double lit = brightness(image.pixel(40, 150)), shaded = brightness(image.pixel(225, 140));
    CHECK(lit > 150);
    CHECK(shaded < 0.8 * lit);                               // the shadow falls to the right
    CHECK(brightness(image.pixel(160, 2)) < 0.7 * lit);      // backdrop above, ground below
    CHECK(image.pixel(160, 2)[2] > image.pixel(160, 2)[0]);  // and it is blue
}

TEST_CASE("outlines are blended, not stepped", "[render]") {
    const Image image = SmallPicture().draw();
    // along the top of the ball every column has a pixel between cloth and backdrop
    int blended = 0;
    for (int x = 140; x < 190; ++x)
        for (int y = 10; y < 60; ++y) {
            const int above = image.pixel(x, y - 1)[0], here = image.pixel(x, y)[0],
                      below = image.pixel(x, y + 1)[0];
            if (below - above > 60 && here > above + 12 && here < below - 12) {
                ++blended;
                break;
            }
        }
    CHECK(blended > 25);
}

TEST_CASE("drawing the same frame again gives the same pixels, whatever was drawn between", "[render]") {
    const SmallPicture picture;
    Renderer renderer(picture.settings, {{&picture.sheet, palette(0)}}, {picture.sphere});
    const Image first = renderer.draw(picture.frame);
    FrameInput other = picture.frame;
    other.cloth[0].row(1).array() += 0.1;
    const Image between = renderer.draw(other);
    CHECK(pixels_apart(first, between) > 1000);
    CHECK(renderer.draw(picture.frame).rgb == first.rgb);
}

TEST_CASE("timing the stages of a frame names each once and changes no pixel", "[render]") {
    const SmallPicture picture;
    Renderer renderer(picture.settings, {{&picture.sheet, palette(0)}}, {picture.sphere});
    std::vector<StageTime> stages;
    CHECK(renderer.draw(picture.frame, &stages).rgb == renderer.draw(picture.frame).rgb);
    CHECK(stages.size() == 8);
    for (const StageTime& stage : stages) {
        CHECK(stage.cpu_seconds >= 0);
        CHECK(std::count_if(stages.begin(), stages.end(),
                            [&](const StageTime& other) { return other.name == stage.name; }) == 1);
    }
}

TEST_CASE("a solid out of sight changes no pixel", "[render]") {
    SmallPicture picture;
    const Image without = picture.draw();
    Pose far_behind;
    far_behind.translation = Vec3(5, 0.3, 30);
    FrameInput frame = picture.frame;
    frame.solid.push_back(far_behind);
    Renderer renderer(picture.settings, {{&picture.sheet, palette(0)}}, {picture.sphere, picture.sphere});
    CHECK(renderer.draw(frame).rgb == without.rgb);
}

TEST_CASE("wire draws lines on the cloth and nowhere else", "[render]") {
    SmallPicture picture(12);
    const Image plain = picture.draw();
    picture.settings.overlay = Overlay::wire;
    const Image wire = picture.draw();
    CHECK(pixels_apart(plain, wire) > 500);
    CHECK(std::equal(plain.pixel(10, 90), plain.pixel(10, 90) + 3, wire.pixel(10, 90)));
    int brighter = 0;
    for (int x = 120; x < 200; ++x)
        brighter += brightness(wire.pixel(x, 80)) > brightness(plain.pixel(x, 80)) + 2;
    CHECK(brighter == 0);
}

TEST_CASE("strain colours stretched cloth red, squeezed cloth blue, and adds its bar", "[render]") {
    SmallPicture picture;
    picture.settings.overlay = Overlay::tint;
    picture.settings.scale = {"strain", {"-5 %", "0", "+5 %"}, diverging_colour};
    const auto drawn_at = [&](float tint) {
        picture.frame.tint = {Eigen::VectorXf::Constant(picture.sheet.vertices(), tint)};
        return picture.draw();
    };
    const Image stretched = drawn_at(1), squeezed = drawn_at(-1), rest = drawn_at(0);
    CHECK(stretched.pixel(160, 80)[0] > stretched.pixel(160, 80)[2] + 60);
    CHECK(squeezed.pixel(160, 80)[2] > squeezed.pixel(160, 80)[0] + 60);
    CHECK(is_grey(rest.pixel(160, 80)));
    picture.settings.overlay = Overlay::none;
    const Image plain = picture.draw();
    int bar = 0;
    for (int y = 140; y < 180; ++y)
        for (int x = 220; x < 320; ++x)
            bar += !std::equal(plain.pixel(x, y), plain.pixel(x, y) + 3, rest.pixel(x, y));
    CHECK(bar > 200);
}

TEST_CASE("springs are drawn in their own colours", "[render]") {
    SmallPicture picture;
    picture.settings.overlay = Overlay::springs;
    picture.frame.segments.ends.resize(3, 2);
    picture.frame.segments.ends << -0.3, 0.3, 0.5, 0.5, 0.4, 0.4;  // in front of the cloth
    picture.frame.segments.colour = {{0, 1, 0}};
    const Image image = picture.draw();
    int green = 0;
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 320; ++x) green += image.pixel(x, y)[1] > image.pixel(x, y)[0] + 60;
    CHECK(green > 50);
}

TEST_CASE("a tilted ground and a cloth without UVs are drawn too", "[render]") {
    SmallPicture picture;
    const Image level = picture.draw();
    picture.sheet.drawn.uv.resize(2, 0);
    DrawnSolid ground;
    ground.surface = make_pattern("one_way", {4, 4, 1, 1});
    ground.is_ground = true;
    Pose tilt;
    tilt.rotation = rotation_from_degrees(Vec3(0, 0, 20));
    picture.frame.solid = {tilt};
    Renderer renderer(picture.settings, {{&picture.sheet, palette(0)}}, {ground});
    const Image tilted = renderer.draw(picture.frame);
    CHECK(is_red(tilted.pixel(160, 80)));
    CHECK(pixels_apart(level, tilted) > 5000);
}

TEST_CASE("pictures of odd and of tiny sizes come out whole", "[render]") {
    SmallPicture picture;
    const auto [width, height] = GENERATE(std::pair{1, 1}, std::pair{33, 17}, std::pair{161, 91});
    picture.settings.width = width;
    picture.settings.height = height;
    const Image image = picture.draw();
    CHECK(image.width == width);
    CHECK(image.height == height);
    CHECK(brightness(image.pixel(width / 2, height / 2)) > 10);
}

TEST_CASE("a picture size no driver can hold is an error", "[render]") {
    SmallPicture picture;
    picture.settings.width = 1 << 20;
    CHECK_THROWS_AS(picture.draw(), Error);
}
