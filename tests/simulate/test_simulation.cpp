#include "simulate/simulation.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

std::vector<Setup> every_setup() {
    std::vector<Setup> setups;
    setups.push_back(swatch(8, 200));
    setups.push_back(flag());
    setups.push_back(ball_drop());
    return setups;
}

}  // namespace

TEST_CASE("the same input gives the same bits", "[simulate]") {
    for (const Setup& setup : every_setup()) {
        Simulation one(setup), two(setup);
        while (one.frame() < one.frames()) {
            const FrameReport first = one.advance(), second = two.advance();
            REQUIRE(first.trouble.empty());
            CHECK(first.hash == second.hash);
            CHECK(first.steps == second.steps);
            CHECK(one.state().v == two.state().v);
        }
    }
}

TEST_CASE("frames come at their times, of equal steps no longer than allowed", "[simulate]") {
    Simulation simulation(swatch(8, 200));
    for (int frame = 1; frame <= 10; ++frame) {
        const FrameReport report = simulation.advance();
        CHECK(report.index == frame);
        CHECK(simulation.frame() == frame);
        CHECK(report.time == frame / 20.0);
        CHECK(simulation.state().time == report.time);
        CHECK(double(report.steps) * simulation.step() == Approx(1 / 20.0).epsilon(1e-12));
        CHECK(report.shortest_step == Approx(simulation.step()).epsilon(1e-9));
        CHECK(simulation.step() < simulation.longest_step());
        CHECK(simulation.step() > 0.8 * simulation.longest_step());
    }
}

TEST_CASE("a step that is asked for is shortened to divide the frame, never lengthened", "[simulate]") {
    Setup setup = swatch(4, 200);
    setup.method = "verlet";
    for (const auto& [asked, steps] : {std::pair{0.001, 50}, {0.00099, 51}, {0.0011, 46}}) {
        setup.step = asked;
        Simulation simulation(setup);
        CHECK(simulation.advance().steps == steps);
        CHECK(simulation.step() == Approx(0.05 / steps));
        CHECK(simulation.method().name == "verlet");
    }
}

TEST_CASE("left to itself drape takes order four where energy is conserved, else one sweep a step",
          "[simulate]") {
    CHECK(Simulation(swatch(4, 200)).method().name == "takahashi_imada");
    CHECK(Simulation(flag(4)).method().name == "verlet");
    CHECK(Simulation(ball_drop(4)).method().name == "verlet");
}

TEST_CASE("a method for conservative scenes refuses others, and says what they have", "[simulate]") {
    using Catch::Matchers::Contains;
    for (const Method& method : methods()) {
        if (!method.conservative_only()) continue;
        Setup damped = flag(2), touching = ball_drop(2), still = swatch(2, 200);
        for (Setup* setup : {&damped, &touching, &still}) setup->method = method.name;
        CHECK_THROWS_WITH(Simulation(damped), Contains(std::string(method.name)) &&
                                                  Contains("(edge springs, ") && Contains("wind") &&
                                                  Contains("moving pins") && Contains("verlet"));
        CHECK_THROWS_WITH(Simulation(touching), Contains("contact"));
        CHECK_NOTHROW(Simulation(still));
    }
}

TEST_CASE("pins that move along keyframes are where the keyframes say at every frame", "[simulate]") {
    const RigidMotion motion = carry(0.05, 0.4, {0.3, 0.1, -0.2}, {0, 90, 10});
    Setup setup = scene_of(square(6), full_fabric(), {0, 3, 6}, motion);
    const Points start = setup.start.x;
    Simulation simulation(std::move(setup));
    while (simulation.frame() < simulation.frames()) {
        REQUIRE(simulation.advance().trouble.empty());
        const State& state = simulation.state();
        const MovingPose pose = motion.at(state.time);
        for (const int pin : {0, 3, 6}) {
            CHECK((state.x.col(pin) - pose.pose * start.col(pin)).norm() < 1e-12);
            CHECK((state.v.col(pin) - pose.velocity_at(state.x.col(pin))).norm() < 1e-11);
        }
    }
}

TEST_CASE("a frame that no halving of its step saves ends in trouble, with the last good state kept",
          "[simulate]") {
    for (const Method& method : methods()) {
        // these would shorten the step, or take it
        if (method.controls_step || method.projects_springs || method.is_implicit()) continue;
        for (Setup setup : {swatch(8, 200), flag()}) {
            if (method.conservative_only() && setup.world.air.drag > 0) continue;
            setup.method = method.name;
            setup.frame_rate = 0.005;
            setup.step = 200;
            setup.frames = 2;
            Simulation simulation(std::move(setup));
            const State before = simulation.state();
            const FrameReport report = simulation.advance();
            CAPTURE(method.name, report.trouble);
            CHECK_THAT(report.trouble, Catch::Contains("ran away") && Catch::Contains("at vertex") &&
                                           Catch::Contains("beyond the longest stable one"));
            CHECK(report.index == 1);
            CHECK(simulation.frame() == 0);
            CHECK(simulation.state().x == before.x);
            CHECK(simulation.state().v == before.v);
            CHECK(simulation.state().time == before.time);
            CHECK(simulation.flow().dissipated == 0);
            CHECK(simulation.flow().driven == 0);
        }
    }
}

TEST_CASE("a cloth of pins alone goes where they go, under every method", "[simulate]") {
    const RigidMotion motion = carry(0.1, 0.4, {0.2, 0, 0}, {0, 90, 0});
    for (const Method& method : methods()) {
        for (const bool moves : {false, true}) {
            if (method.conservative_only()) continue;  // refused with an obstacle
            Setup setup = scene_of(square(1), full_fabric(), {0, 1, 2, 3}, moves ? motion : RigidMotion());
            setup.obstacles.push_back(sphere({0, -0.6, 0}, 0.5));
            setup.method = method.name;
            const Points start = setup.start.x;
            Simulation simulation(std::move(setup));
            CAPTURE(method.name, moves);
            run(simulation);
            const Pose pose = moves ? motion.at(1).pose : Pose();
            for (int i = 0; i < 4; ++i)
                CHECK((simulation.state().x.col(i) - pose * start.col(i)).norm() < 1e-12);
        }
    }
}

TEST_CASE("a frame whose steps have no end is given up and told", "[simulate]") {
    // in the storm the triangles stretch and find more wind than was foreseen
    Setup setup = scene_of(square(1), full_fabric(), {0});
    setup.method = "verlet";
    setup.world.air = {.drag = 0, .aerodynamic = true, .wind = {1e4, 1e4, 0}};
    Simulation simulation(setup);
    const FrameReport report = simulation.advance();
    CHECK_THAT(report.trouble, Catch::Contains(" steps, the last of ") && Catch::Contains(" at vertex "));
    CHECK(simulation.frame() == 0);
    CHECK(simulation.state().x == setup.start.x);
}

TEST_CASE("a run that is asked to stop does so within its frame", "[simulate]") {
    Setup setup = ball_drop();
    int asked = 0;
    setup.stop = [&] { return ++asked == 5; };
    Simulation simulation(setup);
    try {
        simulation.advance();
        FAIL("went on");
    } catch (const Error& stopped) {
        CHECK(stopped.code() == Exit::interrupted);
    }
    CHECK(asked == 5);
}
