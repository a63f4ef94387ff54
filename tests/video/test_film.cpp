#include "video/film.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "picture/panes.h"
#include "picture/resize.h"
#include "support/frames.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;
using Catch::Matchers::Contains;

namespace {

Take take(const std::string& folder) {
    return {find_sequence(folder), {}, "", 0};
}

}  // namespace

TEST_CASE("a film shows one sequence after the other, pixel for pixel", "[video]") {
    const TemporaryFolder folder;
    const auto film = one_after_the_other({take(write_frames(folder.file("a"), 3, 32, 18)),
                                           take(write_frames(folder.file("b"), 2, 32, 18, "frame_", 8))});
    REQUIRE(film->frames() == 5);
    for (const int k : {4, 0, 2, 3, 1})  // in any order
        CHECK(film->frame(k).rgb == moving_disc(k < 3 ? k : k - 3, 32, 18).rgb);
}

TEST_CASE("panes show the sequences' frames of the same number, and what they differ in", "[video]") {
    const TemporaryFolder folder;
    const std::string a = write_frames(folder.file("a"), 3, 32, 18), b = folder.file("b");
    make_folder(b);
    for (const int k : {1, 2, 3})  // one frame ahead
        write_file(b + "/frame_000" + std::to_string(k) + ".png", encode_png(moving_disc(k, 32, 18)));
    const auto film = side_by_side({take(a), take(b)}, {0, true});
    REQUIRE(film->frames() == 3);
    const Image one = moving_disc(1, 32, 18), two = moving_disc(2, 32, 18);
    const Image expected = beside(std::vector{one, two, amplified_difference(one, two, 16)}, 3);
    CHECK(film->frame(1).rgb == expected.rgb);
    const auto column = side_by_side({take(a), take(b)}, {1, false});
    CHECK(column->frame(0).height == 2 * 18 + 2);
}

TEST_CASE("captions follow their frames, and leave the rest of the picture alone", "[video]") {
    const TemporaryFolder folder;
    Take captioned = take(write_frames(folder.file("a"), 2, 160, 90, "frame_", 5));
    captioned.captions = {{"scene", {}}, {{6, {"error 1 mm"}}}};
    captioned.label = "left";
    const auto film = one_after_the_other({captioned});
    const Image first = film->frame(0), second = film->frame(1);
    Image wanted_first = moving_disc(0, 160, 90), wanted_second = moving_disc(1, 160, 90);
    for (Image* image : {&wanted_first, &wanted_second}) draw_caption(*image, {"left", {}}, Corner::top_left);
    draw_caption(wanted_first, {"scene", {}});
    draw_caption(wanted_second, {"scene", {"error 1 mm"}});
    CHECK(first.rgb == wanted_first.rgb);
    CHECK(second.rgb == wanted_second.rgb);
    CHECK(first.rgb != moving_disc(0, 160, 90).rgb);
}

TEST_CASE("pictures are resized before they are captioned", "[video]") {
    const TemporaryFolder folder;
    Take resized_take = take(write_frames(folder.file("a"), 1, 320, 180));
    resized_take.width = 161;
    resized_take.label = "small";
    CHECK(resized_take.height() == 91);
    Image expected = resized(moving_disc(0, 320, 180), 161, 91);
    draw_caption(expected, {"small", {}}, Corner::top_left);
    const Image frame = one_after_the_other({resized_take})->frame(0);
    CHECK(frame.width == 161);
    CHECK(frame.rgb == expected.rgb);
}

TEST_CASE("sequences that do not fit together are refused by name", "[video]") {
    const TemporaryFolder folder;
    const std::string a = write_frames(folder.file("a"), 3, 32, 18),
                      b = write_frames(folder.file("b"), 2, 32, 18),
                      c = write_frames(folder.file("c"), 3, 33, 18);
    CHECK_THROWS_WITH(one_after_the_other({take(a), take(c)}),
                      Contains("c/frame_0001.png: is 33x18 pixels") && Contains("a/frame_0001.png 32x18"));
    CHECK_THROWS_WITH(side_by_side({take(a), take(c)}, {}), Contains("c/frame_0001.png: is 33x18"));
    CHECK_THROWS_WITH(side_by_side({take(a), take(b)}, {}), Contains("b: has 2 frames") && Contains("a 3"));
    CHECK_THROWS_WITH(side_by_side({take(a)}, {0, true}), Contains("of two sequences, not of 1"));
}
