// What a study reports.
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <sstream>

#include "study/findings.h"
#include "study/small_study.h"
#include "study/study_csv.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("no error is ever reported below the reference's bar, nor zero", "[study]") {
    const Study& study = small_study();
    std::set<const Method*> measured;
    for (const Rung& rung : study.rungs) {
        if (!rung.good()) continue;
        CAPTURE(rung.method->name, rung.steps_a_frame);
        measured.insert(rung.method);
        CHECK(rung.errors.final_rms >= study.bar());
        CHECK(rung.errors.final_max >= study.reference.bar.back().max);
        CHECK(rung.errors.time_l2 > 0);
        CHECK(study.bar() > 0);
        CHECK_FALSE(rung.cpu.empty());
    }
    CHECK(measured.size() == methods().size());
}

TEST_CASE("a distance below the bar is reported as the bar", "[study]") {
    const RungErrors errors = reported_errors({{1e-9, 2e-9}, {0, 0}}, {{1e-6, 2e-6}, {3e-6, 4e-6}});
    CHECK(errors.below_bar);
    CHECK(errors.final_rms == 3e-6);
    CHECK(errors.final_max == 4e-6);
    CHECK(errors.time_l2 == Approx(std::sqrt(10e-12 / 2)));
}

TEST_CASE("every method shows its order", "[study]") {
    StudyOptions options;
    options.repeats = 1;
    options.budget = 8;  // long enough under sanitizers too
    options.methods = every_method();
    const Study study = run_study(small_scene(), options, {});
    for (const Method& method : methods()) {
        const SeenOrder order = seen_order(study, method);
        CAPTURE(method.name, order.rungs);
        REQUIRE(order.rungs >= 3);
        CHECK(*order.seen == Approx(order.expected).margin(0.25));  // 0.2 off at most: srkn4
    }
}

TEST_CASE("the csv has a row for each rung and as many fields as its head", "[study]") {
    const Study& study = small_study();
    std::istringstream lines(study_csv(study));
    std::string line;
    std::getline(lines, line);
    const auto fields = [](const std::string& text) {
        int count = 1;
        bool inside = false;
        for (const char c : text) {
            if (c == '"') inside = !inside;
            if (c == ',' && !inside) ++count;
        }
        return count;
    };
    const int wanted = fields(line);
    size_t rows = 0;
    for (; std::getline(lines, line); ++rows) {
        CAPTURE(line);
        CHECK(fields(line) == wanted);
        CHECK_THAT(line, Catch::StartsWith(std::string(study.rungs[rows].method->name) + ","));
    }
    CHECK(rows == study.rungs.size());
}
