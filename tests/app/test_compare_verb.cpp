// compare as its users run it: exit codes, and the files it leaves.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "app/two_runs.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("compare exits with 0 for the same and 1 for different and 2 for bad input", "[app]") {
    const TwoRuns runs;
    const Ran same = run_drape({"compare", "before", "before"}, runs.folder.path());
    CHECK(same.exit_code == 0);
    CHECK_THAT(same.out, Catch::Contains("same: 3 identical"));
    const Ran different = runs.compare();
    CHECK(different.exit_code == 1);
    CHECK_THAT(different.out, Catch::Contains("frame_0003.png: added") &&
                                  Catch::Contains("frame_0004.png: missing") &&
                                  Catch::Contains("1 identical, 1 different, 1 missing, 1 added"));
    CHECK(runs.compare({"--quiet"}).out.empty());
    write_file(runs.folder.file("before/compare.toml"), "shar = 1\n");
    const Ran bad = runs.compare();
    CHECK(bad.exit_code == 2);
    CHECK(bad.error_lines() == 1);
    CHECK_THAT(bad.err,
               Catch::Contains(
                   "before/compare.toml:1:1: unknown compare.toml key \"shar\"; did you mean \"share\"?"));
}

TEST_CASE("compare's flags reach the limits and the reports the disk", "[app]") {
    const TwoRuns runs;
    const std::vector<std::string> pair{"compare", "after/frame_0002.png", "before/frame_0002.png"};
    const auto exit_with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), pair.begin(), pair.end());
        return run_drape(more, runs.folder.path()).exit_code;
    };
    CHECK(exit_with({}) == 1);
    CHECK(exit_with({"--share", "1", "--mean", "255"}) == 0);
    CHECK(exit_with({"--share", "1", "--mean", "255", "--limit", "ssim=0.99"}) == 1);
    CHECK(exit_with({"--ignore", "20,10,50,40"}) == 0);
    CHECK(runs.compare({"--perceptual", "--json", "out.json", "--junit", "out.xml"}).exit_code == 1);
    const auto json = nlohmann::json::parse(bytes_of(runs.folder.file("out.json")));
    CHECK(json["limits"]["mean"] == 2e-3);
    CHECK(json["files"][1]["metrics"]["flip"] > 0);
    CHECK(json["files"][1]["metrics"]["share"] > 0);
    CHECK_THAT(bytes_of(runs.folder.file("out.xml")),
               Catch::Contains("<testsuite name=\"before\" tests=\"4\" failures=\"3\""));
}

TEST_CASE("compare accepts and says how", "[app]") {
    const TwoRuns runs;
    const Ran before = runs.compare({"--limit", "ssim=0.5", "--ignore", "0,0,2,2"});
    CHECK_THAT(
        before.out,
        Catch::Contains("to accept: drape compare after before --limit ssim=0.5 --ignore 0,0,2,2 --accept"));
    CHECK(runs.compare({"--accept"}).exit_code == 0);
    CHECK_THAT(runs.compare().out, Catch::StartsWith("same: 3 identical"));
}
