// `drape lab` from the command line.
#include <catch2/catch.hpp>

#include "lab/experiment.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("drape lab leaves csv, plots and a page, and tells each claim in a line", "[lab]") {
    const TemporaryFolder folder;
    const std::string out = folder.file("out"), name = "jumps";
    const Ran ran = run_drape({"lab", name, "--out", out});
    CAPTURE(ran.err, ran.out);
    CHECK(ran.exit_code == 0);
    CHECK_THAT(ran.out, Catch::StartsWith(name + ": ") && Catch::Contains("\n" + out + "/index.html\n"));
    for (const char* ending : {".csv", ".svg", ".png"}) {
        CAPTURE(ending);
        CHECK_FALSE(bytes_of(out + "/" + name + ending).empty());
    }
    const std::string page = bytes_of(out + "/index.html");
    CHECK_THAT(page, Catch::Contains("<svg") && Catch::Contains("</html>"));
    CHECK_THAT(page, !Catch::Contains("src=\""));
}

TEST_CASE("what the lab cannot do is one line", "[lab]") {
    const struct {
        std::vector<std::string> words;
        std::string says;
    } cases[] = {
        {{"lab", "anisotrpy"}, "did you mean \"anisotropy\"?"},
        {{"lab", "--outt", "x"}, "did you mean \"--out\"?"},
        {{"lab", "fabric", "dnim"}, "did you mean \"denim\"?"},
        {{"lab", "fit", "x.csv"}, "lab fit: expected one file"},
        {{"lab", "fit", "x.csv", "--density", "0.1", "--bending-length", "0.02"}, "x.csv: no such file"},
        {{"lab", "fit", "x.csv", "--density", "-1"}, "--density -1: expected"},
        {{"lab", "jumps", "--density", "1"}, "are for `drape lab fit FILE`"}};
    for (const auto& c : cases) {
        const TemporaryFolder folder;
        const Ran ran = run_drape(c.words, folder.path());
        CAPTURE(ran.err);
        CHECK(ran.exit_code == 2);
        CHECK(ran.error_lines() == 1);
        CHECK_THAT(ran.err, Catch::Contains(c.says));
        CHECK(folder.files() == 0);
    }
}

TEST_CASE("drape lab fit prints the fabric of a measured curve", "[lab]") {
    const TemporaryFolder folder;
    const std::string curve = folder.file("curve.csv", "strain,force\n0.01,3\n0.02,6\n");
    const Ran ran = run_drape(
        {"lab", "fit", curve, "--bending-length", "0.02", "--density", "0.15", "--out", folder.file("out")});
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 0);
    CHECK_THAT(ran.out, Catch::StartsWith(
                            "fit: fabric = { density = 0.15, stretch = { model = \"membrane\", value = "));
    CHECK_THAT(bytes_of(folder.file("out") + "/fit.csv"), Catch::StartsWith("strain,measured_n_per_m"));
}

TEST_CASE("list names every experiment", "[lab]") {
    const Ran ran = run_drape({"list", "lab"});
    CHECK(ran.exit_code == 0);
    for (const Experiment& experiment : experiments())
        CHECK_THAT(ran.out, Catch::Contains(std::string(experiment.name)));
}
