#include "video/captions.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "support/temporary_folder.h"

using namespace drape;

namespace {

std::string report(const std::string& step, const std::string& error) {
    return "{\"scene\": \"drop\", \"method\": {\"name\": \"verlet\", \"step_s\": " + step +
           "}, \"time\": {\"total_s\": 3.0}, \"frames\": ["
           "{\"index\": 1, \"time_s\": 0.04, \"error_m\": " +
           error + "}, {\"index\": 2, \"time_s\": 0.08, \"error_m\": 0.033}]}";
}

}  // namespace

TEST_CASE("a report tells scene, method, step, cost, and of each frame time and error", "[video]") {
    const TemporaryFolder folder;
    const ReportedRun run = read_reported_run(folder.file("report.json", report("1.234e-4", "8.7e-6")));
    CHECK(run.frame_rate == Approx(25));
    CHECK(run.captions.common.title == "drop");
    using Facts = std::vector<std::string>;
    CHECK(run.captions.common.facts == Facts{"verlet", "step 0.12 ms", "1500 ms a frame"});
    CHECK(run.captions.of(1).facts ==
          Facts{"verlet", "step 0.12 ms", "1500 ms a frame", "t = 0.04 s", "error 8.7 µm"});
    CHECK(run.captions.of(2).facts.back() == "error 33 mm");
    CHECK(run.captions.of(7).facts == run.captions.common.facts);  // not in the report
}

TEST_CASE("numbers of a report are told in units that suit them, unknown ones not at all", "[video]") {
    const TemporaryFolder folder;
    const auto last = [&](const std::string& error) {
        return read_reported_run(folder.file("report.json", report("6.5e-5", error)))
            .captions.of(1)
            .facts.back();
    };
    CHECK(last("0.1049") == "error 105 mm");
    CHECK(last("0.0999") == "error 100 mm");
    CHECK(last("0.00013") == "error 0.13 mm");
    CHECK(last("1.5e-10") == "error 0.15 nm");
    CHECK(last("0") == "error 0");
    CHECK(last("null") == "t = 0.04 s");
    CHECK(read_reported_run(folder.file("report.json", report("6.5e-5", "0"))).captions.common.facts[1] ==
          "step 65 µs");
    CHECK(read_reported_run(folder.file("report.json", report("null", "0"))).captions.common.facts[1] ==
          "1500 ms a frame");
}

TEST_CASE("a report.json of something else is refused by name", "[video]") {
    const TemporaryFolder folder;
    for (const char* text : {"no json", "[]", "{\"scene\": 3}", "{\"scene\": \"x\", \"method\": {}}"}) {
        const std::string path = folder.file("report.json", text);
        CHECK_THROWS_WITH(read_reported_run(path),
                          Catch::Contains("report.json: is no report.json of a run"));
    }
}
