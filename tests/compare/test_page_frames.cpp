#include "compare/page_frames.h"

#include <catch2/catch.hpp>

#include "compare/pictures.h"
#include "io/png.h"
#include "io/write_file.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;
using Catch::Contains;

namespace {

Compared frame(int number, Verdict verdict, double mean) {
    return {.name = "frame_" + std::to_string(1000 + number) + ".png",
            .verdict = verdict,
            .picture = PictureDifference{.mean_levels = mean}};
}

}  // namespace

TEST_CASE("the page shows the first bad frame and the worst and leaves out the rest", "[compare]") {
    Comparison comparison;
    for (int i = 0; i < 10; ++i) comparison.files.push_back(frame(i, Verdict::identical, 0));
    for (int i = 10; i < 20; ++i) comparison.files.push_back(frame(i, Verdict::within, i));
    for (int i = 20; i < 80; ++i)
        comparison.files.push_back(frame(i, Verdict::different, i == 20 ? 1 : 1000 - i));
    comparison.files.push_back({.name = "cloth.pc2", .verdict = Verdict::different});
    const std::vector<ShownFrame> shown = shown_frames(comparison);
    REQUIRE(shown.size() == 16);
    CHECK(shown[0].file == 20);  // the first bad one, though the least bad
    CHECK(shown[1].file == 21);
    CHECK(shown[13].file == 33);
    CHECK(shown[14].file == 18);  // the two worst that passed
    CHECK(shown[15].file == 19);
    int full = 0;
    for (const ShownFrame& one : shown) full += !one.small;
    CHECK(full == 2);
    CHECK_FALSE(shown[0].small);
    CHECK_FALSE(shown[1].small);
    CHECK(shown[15].small);
}

TEST_CASE("a frame's pictures are those there are", "[compare]") {
    const TemporaryFolder folder;
    write_file(folder.file("a.png"), encode_png(plain(40, 30)));
    write_file(folder.file("b.png"), encode_png(disc(40, 30, 20, 15, 8)));
    write_file(folder.file("wide.png"), encode_png(plain(50, 30)));
    const auto figures = [&](Verdict verdict, const std::string& result, const std::string& reference) {
        Compared file{.name = "x.png", .verdict = verdict};
        return frame_figures(file, {folder.file(result), folder.file(reference), {}}, false);
    };
    const std::string all = figures(Verdict::different, "a.png", "b.png");
    for (const char* kind : {"result", "reference", "difference", "perception"})
        CHECK_THAT(all, Contains(std::string("<figure class=\"") + kind + "\">"));
    CHECK_THAT(figures(Verdict::added, "a.png", "none.png"),
               Contains("\"result\"") && !Contains("\"reference\""));
    CHECK_THAT(figures(Verdict::missing, "none.png", "b.png"),
               !Contains("\"result\"") && Contains("\"reference\""));
    CHECK_THAT(figures(Verdict::different, "wide.png", "b.png"),
               Contains("\"result\"") && !Contains("\"difference\""));
}

TEST_CASE("small pictures are small and what an eye would say is of the full ones", "[compare]") {
    const TemporaryFolder folder;
    write_file(folder.file("a.png"), encode_png(random_picture(1000, 60, 1)));
    write_file(folder.file("b.png"), encode_png(random_picture(1000, 60, 2)));
    Compared file{.name = "x.png", .verdict = Verdict::different};
    const ComparedPaths paths{folder.file("a.png"), folder.file("b.png"), {}};
    const size_t small = frame_figures(file, paths, true).size();
    REQUIRE(file.perceived);
    const double flip = file.perceived->flip;
    CHECK(small < frame_figures(file, paths, false).size() / 4);
    CHECK(file.perceived->flip == flip);
}
