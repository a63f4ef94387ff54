#include "report/report.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "integrate/method.h"

using namespace drape;

namespace {

RunReport two_frames() {
    RunReport report;
    report.scene = "a \"quoted\" scene";
    report.version = "1.2.3";
    report.method = &method_named("verlet");
    report.chosen_because = "asked for";
    report.step = 1e-4;
    report.longest_step = 2e-4;
    report.error.asked = 1e-3;
    report.error.reached = true;
    report.error.rms = 2e-4;
    report.error.how = "by a test";
    report.error.passes.push_back({"verlet", "delivered", 1e-4, 300, 301, 2e-4, 0.5});
    report.guaranteed_step = 1.5e-4;
    report.start = {0, 10};
    report.end = {1, 6};
    report.flow = {3.5, 0.25};
    report.plan.use("gravity", "9.81");
    report.plan.leave_out("wind", "no air.wind");
    FrameReport frame;
    frame.index = 1;
    frame.steps = 40;
    frame.contacts = 7;
    frame.least_distance = 0.002;
    report.frames.push_back(frame);
    frame.index = 2;
    frame.steps = 60;
    frame.contacts = 5;
    frame.least_distance = -0.001;
    report.frames.push_back(frame);
    return report;
}

}  // namespace

TEST_CASE("report.json says what the frames add up to, and null where nothing is known", "[report]") {
    const auto json = nlohmann::json::parse(report_json(two_frames()));
    CHECK(json["scene"] == "a \"quoted\" scene");
    CHECK(json["method"]["steps"] == 100);
    CHECK(json["method"]["margin"] == Approx(2));
    CHECK(json["energy"]["drift_j"] == Approx(7 - 10 - 0.25 + 3.5));
    CHECK(json["contact"]["deepest_penetration_m"] == Approx(0.001));
    CHECK(json["contact"]["contacts_max"] == 7);
    CHECK(json["error"]["how"] == "by a test");
    CHECK(json["error"]["asked_m"] == 1e-3);
    CHECK(json["error"]["estimated_rms_m"] == 2e-4);
    CHECK(json["error"]["reached"] == true);
    CHECK(json["error"]["passes"].size() == 1);
    CHECK(json["error"]["predictability_floor_m"].is_null());
    CHECK(json["plan"]["used"] == nlohmann::json{"gravity"});
    CHECK(json["plan"]["left_out"][0]["because"] == "no air.wind");
    CHECK(json["frames"].size() == 2);
    CHECK(json["machine"]["renderer"].is_null());
}

TEST_CASE("crossings are the most of any frame and the last, and null where none were counted", "[report]") {
    RunReport report = two_frames();
    CHECK(nlohmann::json::parse(report_json(report))["contact"]["crossings"].is_null());
    CHECK_THAT(report_summary(report), !Catch::Contains("crosses"));
    for (FrameReport& frame : report.frames) frame.crossings = 0;
    CHECK_THAT(report_summary(report), Catch::Contains("cloth crosses itself in no frame"));
    report.frames[0].crossings = 3;
    const auto json = nlohmann::json::parse(report_json(report));
    CHECK(json["contact"]["crossings"] == 3);
    CHECK(json["contact"]["crossings_last"] == 0);
    CHECK(json["frames"][0]["crossings"] == 3);
    CHECK_THAT(report_summary(report), Catch::Contains("up to 3 pairs of triangles, 0 at the end"));
}

TEST_CASE("without obstacles no distance is made up", "[report]") {
    RunReport report = two_frames();
    for (FrameReport& frame : report.frames) frame.least_distance = INFINITY;
    const auto json = nlohmann::json::parse(report_json(report));
    CHECK(json["contact"]["least_distance_m"].is_null());
    CHECK(json["contact"]["deepest_penetration_m"] == 0);
    CHECK_THAT(report_summary(report), !Catch::Contains("contact:"));
}

TEST_CASE("the summary gives steps, cost, energy and contact", "[report]") {
    const std::string text = report_summary(two_frames());
    for (const char* part : {"2 frames, 100 steps of verlet", "CPU", "energy 10 -> 7 J",
                             "7 points, up to 1 mm inside an obstacle"})
        CHECK_THAT(text, Catch::Contains(part));
}
