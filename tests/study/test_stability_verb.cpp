// `drape stability` from the command line.
#include <regex>

#include <catch2/catch.hpp>

#include "support/run_program.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;

namespace {

// Axis labels stand wholly within the picture, a lower one under each of `columns` panels.
void check_axis_labels(const std::string& svg, int columns) {
    constexpr double letter = 12, line = 8;  // height with what overhangs, to the lower edge [pixels]
    std::smatch size;
    REQUIRE(std::regex_search(svg, size, std::regex("height=\"(\\d+)\"")));
    const double height = std::stod(size[1]);
    int sideways = 0, below = 0;
    const std::regex text(R"(translate\(([-.\d]+),([-.\d]+)\)[^>]*>\s*<text><tspan[^>]*>(step|spring))");
    for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) {
        CAPTURE(it->str());
        const bool upright = (*it)[3] == "spring";
        CHECK(std::stod((*it)[1]) > letter);
        CHECK(std::stod((*it)[2]) < height - line);
        ++(upright ? below : sideways);
    }
    CHECK(sideways == 1);
    CHECK(below == columns);
}

}  // namespace

TEST_CASE("drape stability leaves a csv, maps and a page, and nothing half-written", "[study]") {
    const TemporaryFolder folder;
    const std::string out = folder.file("out");
    const Ran ran = run_drape({"stability", "--out", out, "--method", "verlet", "--runs", "1"});
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 0);
    CHECK_THAT(ran.out, Catch::StartsWith("verlet: stable up to ") && Catch::Contains("\nauto: "));
    std::vector<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator(out))
        left.push_back(entry.path().filename());
    CHECK_THAT(left, Catch::UnorderedEquals(std::vector<std::string>{
                         "alternating.png", "alternating.svg", "collapse.csv", "auto.png", "auto.svg",
                         "index.html", "plots.gp", "stability.csv"}));
    CHECK_THAT(bytes_of(out + "/stability.csv"), Catch::Contains("\nauto,slivers,"));
    CHECK_THAT(bytes_of(out + "/index.html"),
               Catch::Contains("f0_gnuplot") && Catch::Contains("f1_gnuplot") && Catch::Contains("</html>"));
    check_axis_labels(bytes_of(out + "/alternating.svg"), 2);
    check_axis_labels(bytes_of(out + "/auto.svg"), 3);
}

TEST_CASE("drape stability takes a scene's cloth", "[study]") {
    const TemporaryFolder folder;
    const std::string scene =
        folder.file("tiny.toml",
                    "schema = 1\n[scene]\nname = \"tiny <one>\"\nduration = 0.1\nframe_rate = 20\n"
                    "[[cloth]]\npattern = { name = \"alternating\", size = [1, 1], divisions = [2, 2] }\n"
                    "fabric = \"cotton\"\npins = [{ near = [0.5, 0, 0.5] }]\n");
    const std::string out = folder.file("out");
    const Ran ran = run_drape({"stability", scene, "--out", out, "--method", "verlet", "--method", "verlet",
                               "--threads", "2", "--quiet"});
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 0);
    CHECK(ran.err.empty());
    CHECK(ran.out.empty());
    CHECK_THAT(bytes_of(out + "/stability.csv"), Catch::Contains("\nverlet,tiny <one>,as in the scene,"));
    CHECK_THAT(bytes_of(out + "/index.html"),
               Catch::Contains("tiny &lt;one&gt;") && Catch::Contains("without obstacles and air"));
    // a method given twice is one method
    const std::string csv = bytes_of(out + "/stability.csv"),
                      cell = "\nverlet,tiny <one>,as in the scene,0.01,1e-05,";
    CHECK(csv.find(cell) != std::string::npos);
    CHECK(csv.find(cell) == csv.rfind(cell));
}

TEST_CASE("what stability cannot do is one line", "[study]") {
    const TemporaryFolder folder;
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"stability", "--method", "verlett"},
          {"stability", "--set", "scene.duration=1"},
          {"stability", "--runs", "0"},
          {"stability", "nowhere"}}) {
        const Ran ran = run_drape(words, folder.path());
        CAPTURE(ran.err);
        CHECK(ran.exit_code == 2);
        CHECK(ran.error_lines() == 1);
        CHECK(folder.files() == 0);
    }
}

TEST_CASE("drape stability interrupted ends with 130 and leaves nothing half-written", "[study]") {
    const TemporaryFolder folder;
    const std::string out = folder.file("out");
    const auto interrupted = [&](const char* sign) {
        return interrupted_drape({"stability", "--out", out, "--method", "verlet", "--runs", "2", "--quiet"},
                                 [&] { return std::filesystem::exists(out + sign); });
    };
    CHECK(interrupted("") == 130);
    CHECK(std::filesystem::is_empty(out));
    // while gnuplot draws
    CHECK(interrupted("/plots.gp") == 130);
    CHECK_FALSE(std::filesystem::exists(out + "/index.html"));
    for (const auto& entry : std::filesystem::directory_iterator(out))
        CHECK_THAT(entry.path().filename().string(), !Catch::Contains("part"));
}
