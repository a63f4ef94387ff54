// The same bits for any number of threads, and --verify-hashes, which says where they are others.
#include <catch2/catch.hpp>

#include "app/small_drop.h"
#include "support/run_program.h"

using namespace drape;
using namespace drape::test;

namespace {

#ifdef DRAPE_WITH_RENDER
constexpr const char* verb = "render";
#else
constexpr const char* verb = "simulate";
#endif

// A run's report, and others that say what it does not.
struct Verified {
    TemporaryFolder folder;
    std::string scene = folder.file("drop.toml", small_drop());
    Json report;

    Verified() {
        const Ran ran = run_drape({verb, scene, "--threads", "1", "--out", folder.file("first")});
        CAPTURE(ran.err);
        REQUIRE(ran.exit_code == 0);
        report = report_of(folder.file("first"));
    }
    Ran verify(const Json& against, const std::string& threads = "1") const {
        Ran ran = run_drape({verb, scene, "--threads", threads, "--out", folder.file("out" + threads),
                             "--verify-hashes", folder.file("against.json", against.dump())});
        ran.err.erase(0, ran.err.rfind("\ndrape: ") + 1);  // lines of progress
        return ran;
    }
};

void differs(const Ran& ran, const std::string& says) {
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 1);
    CHECK(ran.error_lines() == 1);
    CHECK_THAT(ran.err, Catch::Contains(says));
}

}  // namespace

TEST_CASE("positions and pictures have the same bits with 1 and 2 and 3 and 8 threads", "[app]") {
    const Verified run;
    for (const Json& frame : run.report["frames"]) {
        CHECK(frame["hash"].get<std::string>().size() == 16);
        CHECK(frame["picture_hash"].is_string() == (std::string(verb) == "render"));
    }
    for (const char* threads : {"2", "3", "8"}) {
        const Ran ran = run.verify(run.report, threads);
        CAPTURE(threads, ran.err);
        CHECK(ran.exit_code == 0);
        CHECK_THAT(ran.out, Catch::Contains("positions of 4 frames"));
    }
}

TEST_CASE("the first frame that differs from a report is named with its stage", "[app]") {
    const Verified run;
    Json other = run.report;
    other["frames"][2]["hash"] = "0123456789abcdef";
    differs(run.verify(other), "frame 3: positions (");
    // the report that stays is of no run that was stopped
    CHECK_FALSE(std::filesystem::exists(run.folder.file("out1/report.json")));
#ifdef DRAPE_WITH_RENDER
    other["frames"][1]["picture_hash"] = "0123456789abcdef";
    differs(run.verify(other), "frame 2: picture (");
    other = run.report;
    other["frames"][3]["picture_hash"] = "0123456789abcdef";
    differs(run.verify(other, "3"), "frame 4: picture (");
#endif
}

TEST_CASE("a report that cannot be verified against is refused before the run", "[app]") {
    const Verified run;
    const auto refused = [&](const Json& against, const std::string& says) {
        const Ran ran = run.verify(against);
        CAPTURE(ran.err);
        CHECK(ran.exit_code == 2);
        CHECK(ran.error_lines() == 1);
        CHECK_THAT(ran.err, Catch::Contains(says));
    };
    Json other = run.report;
    other["frames"].erase(3);
    refused(other, "has 3 frames, this run 4");
    other["frames"].erase(1);
    refused(other, "frame 2 is missing");
    other = run.report;
    other["scene"] = "flag";
    refused(other, "is of the scene \"flag\", not of \"drop\"");
    refused(Json::array(), "is no report.json of a run");
    CHECK_FALSE(std::filesystem::exists(run.folder.file("out1")));
}
