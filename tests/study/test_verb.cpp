// `drape study` from the command line.
#include <catch2/catch.hpp>

#include "support/run_program.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("drape study leaves a csv, plots and a page, and nothing half-written", "[study]") {
    const TemporaryFolder folder;
    const std::string scene =
        folder.file("tiny.toml",
                    "schema = 1\n[scene]\nname = \"tiny <one>\"\nduration = 0.1\nframe_rate = 20\n"
                    "[[cloth]]\npattern = { name = \"alternating\", size = [1, 1], divisions = [4, 4] }\n"
                    "fabric = { density = 0.2, stretch = { model = \"spring_constant\", value = 100 } }\n"
                    "pins = [{ near = [0.5, 0, 0.5] }]\n");
    const std::string out = folder.file("out");
    const Ran ran = run_drape({"study", scene, "--out", out, "--budget", "3", "--repeats", "1", "--method",
                               "verlet", "--method", "takahashi_imada", "--refine", "--quiet"});
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 0);
    CHECK(ran.err.empty());
    std::vector<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator(out))
        left.push_back(entry.path().filename());
    CHECK_THAT(left, Catch::UnorderedEquals(std::vector<std::string>{
                         "error_over_time.png", "error_over_time.svg", "error_time.png", "error_time.svg",
                         "index.html", "plots.gp", "study.csv"}));
    CHECK_THAT(bytes_of(out + "/study.csv"), Catch::Contains("\ntakahashi_imada,"));
    const std::string page = bytes_of(out + "/index.html");
    CHECK_THAT(page, Catch::Contains("tiny &lt;one&gt;") && Catch::Contains("The mesh&#39;s own error") &&
                         Catch::Contains("a_gnuplot_plot_1") && Catch::Contains("</html>"));
}

TEST_CASE("what study cannot do is one line", "[study]") {
    const TemporaryFolder folder;
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{"--until", "99"}, {"--method", "verlett"}, {"--budget", "0"}}) {
        std::vector<std::string> words{"study", "hanging_swatch", "--out", folder.file("out")};
        words.insert(words.end(), more.begin(), more.end());
        const Ran ran = run_drape(words);
        CAPTURE(ran.err);
        CHECK(ran.exit_code == 2);
        CHECK(ran.error_lines() == 1);
    }
}
