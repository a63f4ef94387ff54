// Which steps each method is tried with.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "study/small_study.h"

using namespace drape;
using namespace drape::test;

namespace {

Probe probe_of(const Setup& setup) {
    return probe_scene(setup, {}, 1000);
}

}  // namespace

TEST_CASE("explicit methods start just below their longest stable step, implicit ones at a frame",
          "[study]") {
    const Setup setup = small_scene();
    Ladder ladder(setup, probe_of(setup), every_method(), false);
    std::map<const Method*, Rung> first;
    while (const std::optional<Rung> rung = ladder.next()) {
        first.emplace(rung->method, *rung);
        Rung told = *rung;
        told.left_out = "enough for this test";
        ladder.done(told);
    }
    CHECK(first.size() == methods().size());
    for (const auto& [method, rung] : first) {
        CAPTURE(method->name);
        if (method->is_implicit() || method->projects_springs) {  // springs set them no limit
            CHECK(rung.steps_a_frame == 1);
            continue;
        }
        const Simulation simulation(with_steps(setup, method->name, 1));
        CHECK(rung.step <= 0.98 * simulation.longest_step());
        const bool longest = rung.steps_a_frame == 1 || 1 / setup.frame_rate / (rung.steps_a_frame - 1) >
                                                            0.98 * simulation.longest_step();
        CHECK(longest);
    }
}

TEST_CASE("a method for scenes that conserve energy is refused elsewhere, with its reason", "[study]") {
    Setup setup = flag(3);
    setup.frames = 1;
    const Ladder ladder(setup, probe_of(setup), every_method(), false);
    REQUIRE_FALSE(ladder.refused().empty());
    for (const RefusedMethod& refused : ladder.refused()) {
        CHECK(refused.method->conservative_only());
        CHECK_THAT(refused.why, Catch::Contains("conserve energy"));
    }
}

TEST_CASE("the ladder keeps to its budget, and names what it leaves out", "[study]") {
    StudyOptions options;
    options.repeats = 1;
    options.budget = 0.4;
    options.methods = every_method();
    const Study study = run_study(swatch(8, 2000), options, {});
    double spent = 0;
    for (const Rung& rung : study.rungs) spent += rung.pass.cpu_seconds;
    CHECK(spent < options.budget);
    const bool some_left_out = std::any_of(study.rungs.begin(), study.rungs.end(),
                                           [](const Rung& r) { return !r.left_out.empty(); });
    CHECK(some_left_out);
    for (const Rung& rung : study.rungs)
        if (!rung.left_out.empty()) CHECK_THAT(rung.left_out, Catch::Contains("CPU s"));
}
