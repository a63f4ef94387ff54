// Energy from nowhere is seen, and answered with shorter steps; motion that is as it should be is left alone.
#include "simulate/guard.h"

#include <catch2/catch.hpp>

#include "support/setups.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("the guard lets a fall pass and stops speeds that no energy was there for", "[simulate]") {
    Simulation simulation(swatch(8, 200));
    Guard guard(simulation.dynamics(), {0, -9.81, 0}, {});
    State state = simulation.state();
    guard.begin_frame(state, 0.05);
    CHECK(guard.step_holds(state.v));
    state.v.row(1).setConstant(-0.5);  // a fall of 0.05 s
    CHECK(guard.step_holds(state.v));
    state.v.row(1).setConstant(-5);
    CHECK_FALSE(guard.step_holds(state.v));
    state.v(1, 40) = NAN;
    CHECK_FALSE(guard.step_holds(state.v));
    CHECK_FALSE(Guard(simulation.dynamics(), {0, -9.81, 0}, {.drive = false}).step_holds(state.v));
}

TEST_CASE("the balance of a frame counts what came and went", "[simulate]") {
    Simulation simulation(flag());
    Guard guard(simulation.dynamics(), {0, -9.81, 0}, {});
    const State before = simulation.state();
    guard.begin_frame(before, 0.05);
    REQUIRE(simulation.advance().trouble.empty());
    CHECK(std::abs(guard.gain(simulation.state())) < 0.01);
    State faster = simulation.state();
    faster.v *= 2;
    CHECK(guard.gain(faster) > Guard::most_gain);
    State stretched = simulation.state();
    stretched.x *= 1.2;
    CHECK(guard.gain(stretched) > Guard::most_gain);
}

TEST_CASE("at steps left to drape no frame is tried twice", "[simulate]") {
    Setup stiff = swatch(8, 1e6), twirl = flag(), drop = ball_drop();
    for (Setup& setup : {std::ref(stiff), std::ref(twirl), std::ref(drop)}) {
        for (const Method& method : methods()) {
            if (method.conservative_only() && &setup != &stiff) continue;
            setup.method = method.name;
            Simulation simulation(setup);
            CAPTURE(method.name);
            for (int k = 0; k < 5; ++k) {
                const FrameReport report = simulation.advance();
                CHECK(report.trouble.empty());
                CHECK(report.retries == 0);
            }
        }
    }
}

TEST_CASE("frames whose step is too long are made with shorter ones, and say how often they were tried",
          "[simulate]") {
    for (const Method& method : methods()) {
        if (method.controls_step || method.projects_springs || method.is_implicit()) continue;
        for (Setup setup : {swatch(8, 200), flag()}) {
            if (method.conservative_only() && setup.world.air.drag > 0) continue;
            setup.method = method.name;
            const double longest = Simulation(setup).longest_step();
            setup.step = 6 * longest;
            Simulation simulation(setup);
            const double start = simulation.energies().total();
            int retries = 0;
            CAPTURE(method.name, longest);
            while (simulation.frame() < simulation.frames()) {
                const FrameReport report = simulation.advance();
                REQUIRE(report.trouble.empty());
                retries += report.retries;
                CHECK(report.strain < 1);
            }
            CHECK(retries > 0);
            CHECK(simulation.energies().total() < start + simulation.flow().driven + 0.2);
        }
    }
}
