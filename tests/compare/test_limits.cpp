#include "compare/limits.h"

#include <catch2/catch.hpp>

#include "compare/pictures.h"
#include "support/meshes.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;

namespace {

LimitFile read(const std::string& text) {
    const TemporaryFolder folder;
    return read_limits(folder.file("compare.toml", text));
}

// what is wrong with a compare.toml, from its name on
std::string refusal(const std::string& text) {
    const std::string message = error_of([&] { read(text); });
    const size_t name = message.find("compare.toml");
    return name == std::string::npos ? message : message.substr(name);
}

}  // namespace

TEST_CASE("compare.toml gives limits with units for all and for one and what to ignore", "[compare]") {
    const LimitFile file = read(
        "share = 1e-4\nssim = 0.98\nrms = \"10 um\"\nignore = [[0, 0, 200, 40], [5, 6, 7, 8]]\n"
        "[file.\"frame_0003.png\"]\nmean = 0.5\n");
    CHECK(file.limits.at("share") == 1e-4);
    CHECK(file.limits.at("ssim") == 0.98);
    CHECK(file.limits.at("rms") == Approx(1e-5));
    CHECK(file.limits.size() == 3);
    REQUIRE(file.ignore.size() == 2);
    CHECK(file.ignore[1].height == 8);
    REQUIRE(file.special.size() == 1);
    CHECK(file.special[0].file == "frame_0003.png");
    CHECK(file.special[0].limits.at("mean") == 0.5);
    CHECK(read_limits("nowhere/compare.toml").limits.empty());
}

TEST_CASE("a slip in compare.toml is one line with its place", "[compare]") {
    const auto says = [](const std::string& text, const std::string& expected) {
        CAPTURE(text);
        CHECK_THAT(refusal(text), Catch::Contains(expected));
    };
    says("shar = 1\n", "compare.toml:1:1: unknown compare.toml key \"shar\"; did you mean \"share\"?");
    says("share = 2\n", "compare.toml:1:9: share must be from 0 to 1, got 2");
    says("\nmean = -1\n", "compare.toml:2:8: mean must be from 0 to 255, got -1");
    says("rms = \"1 mn\"\n", "units: m, cm, mm");
    says("flip = true\n", "compare.toml:1:8: flip: expected a number, found true");
    says("ignore = [0, 0, 1, 1]\n",
         "compare.toml:1:11: ignore: a rectangle X, Y, W, H: expected an array of 4");
    says("ignore = [[0, 0, 0, 1]]\n", "ignore: a rectangle's size must be from 1");
    says("file = 3\n", "compare.toml:1:8: file: expected tables");
    says("[file.\"a.png\"]\nmeen = 1\n",
         "compare.toml:2:1: unknown file.\"a.png\" key \"meen\"; did you mean \"mean\"?");
    says("[file.\"a.png\"]\nignore = []\n", "unknown file.\"a.png\" key \"ignore\"");
    says("share = \n", "compare.toml:1");
}

TEST_CASE("a limit of the command line is a key and a number in its range", "[compare]") {
    Limits limits;
    add_limit(limits, "flip=0.02");
    add_limit(limits, "rms=1e-3");
    CHECK(limits.at("flip") == 0.02);
    CHECK(limits.at("rms") == 1e-3);
    const auto refused = [&](const std::string& text) { return error_of([&] { add_limit(limits, text); }); };
    CHECK_THAT(refused("flp=1"), Catch::Contains("did you mean \"flip\"?"));
    CHECK_THAT(refused("flip=2"), Catch::Contains("flip: expected a number from 0 to 1, found \"2\""));
    CHECK_THAT(refused("flip"), Catch::Contains("found \"\""));
    CHECK_THAT(refused("flip=0.1x"), Catch::Contains("expected a number"));
    CHECK_THAT(refused("largest=nan"), Catch::Contains("of at least 0 in metres"));
    CHECK_THAT(refused("="), Catch::Contains("unknown limit"));
}

TEST_CASE("a rectangle is four whole numbers", "[compare]") {
    const Rectangle r = rectangle_of("1,2,30,40");
    CHECK((r.x == 1 && r.y == 2 && r.width == 30 && r.height == 40));
    for (const char* text :
         {"", "1,2,3", "1,2,3,4,5", "1,2,0,4", "-1,2,3,4", "1, 2,3,4", "a,b,c,d", "1,2,3,9999999"})
        CHECK_THAT(error_of([&] { rectangle_of(text); }), Catch::Contains("expected X,Y,W,H"));
}

TEST_CASE("nothing differs in what is ignored and what lies outside is told", "[compare]") {
    const Image reference = plain(20, 10, 50);
    Image picture = plain(20, 10, 90);
    ignore(picture, reference, {{15, 5, 100, 100}});
    CHECK(picture.pixel(15, 5)[0] == 50);
    CHECK(picture.pixel(19, 9)[2] == 50);
    CHECK(picture.pixel(14, 5)[0] == 90);
    CHECK(picture.pixel(15, 4)[0] == 90);
    CHECK_THAT(error_of([&] {
                   ignore(picture, reference, {{20, 0, 1, 1}});
               }),
               Catch::Contains("outside of the picture (20x10"));
}
