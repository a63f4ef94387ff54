// What errors are measured against: two runs made in two ways agree.
#include <catch2/catch.hpp>

#include "study/reference.h"
#include "study/sundials_reference.h"
#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

Reference reference_of(Setup setup, double most_cpu) {
    const Probe probe = probe_scene(setup, setup.frames / setup.frame_rate, 1000);
    REQUIRE(probe.frames == setup.frames);
    return make_reference(setup, probe, most_cpu);
}

}  // namespace

TEST_CASE("drape's own reference and SUNDIALS agree on an undamped swatch and a damped flag", "[study]") {
    for (Setup setup : {swatch(6, 300), flag(6)}) {
        const Reference reference = reference_of(setup, 20);
        CAPTURE(reference.how, reference.checked_by);
        CHECK_THAT(reference.checked_by, Catch::StartsWith("SUNDIALS"));
        REQUIRE(reference.x.size() == static_cast<size_t>(setup.frames));
        for (const ErrorNorms& bar : reference.bar) {
            CHECK(bar.rms > 0);
            CHECK(bar.rms < 1e-7);
            CHECK(bar.max >= bar.rms);
        }
    }
}

TEST_CASE("where an obstacle has friction a second run of drape's own checks, and says why", "[study]") {
    Setup setup = ball_drop(4);
    setup.frames = 6;
    const Reference reference = reference_of(setup, 4);
    CHECK_THAT(reference.checked_by, Catch::Contains("friction") && Catch::Contains("rk4"));
    CHECK(reference.bar.back().rms > 0);
}

TEST_CASE("SUNDIALS carries moving pins along, and keeps contact without friction outside", "[study]") {
    Setup setup = ball_drop(4);
    for (Obstacle& obstacle : setup.obstacles) obstacle.friction = 0;
    setup.frames = 6;
    const SundialsRun run = run_sundials(setup, 20);
    CAPTURE(run.how);
    REQUIRE(run.x.size() == 6);
    const Simulation simulation(setup);
    for (size_t k = 0; k < run.x.size(); ++k)
        CHECK(simulation.obstacles()[0].solid->sample(run.x[k].col(12)).distance > 0);
}

TEST_CASE("a referee that would cost too much says so instead", "[study]") {
    const SundialsRun run = run_sundials(swatch(6, 300), 1e-9);
    CHECK(run.x.empty());
    CHECK_THAT(run.how, Catch::Contains("would cost"));
}
