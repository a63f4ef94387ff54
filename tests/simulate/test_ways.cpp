// Which way `auto` takes, and that what it states holds on every way.
#include "simulate/ways.h"

#include <catch2/catch.hpp>

#include "simulate/delivery.h"
#include "simulate/error_estimate.h"
#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

Setup stiff(int divisions = 16) {
    Setup setup = swatch(divisions, 50000);
    setup.frame_rate = 50;
    return setup;
}

struct Met {
    std::string method;
    double stated = 0, truth = 0;  // worst frame's [m]
    size_t passes = 0;
};

// against a run of SRKN6, or of RK4 where energy is lost, with steps that no way takes
Met met(const Setup& setup, double tolerance) {
    const auto delivery = make_delivery(setup, {.tolerance = tolerance});
    Setup fine = setup;
    fine.refine = 4;
    fine.method = Simulation(setup).dynamics().is_conservative() ? "srkn6" : "rk4";
    Simulation exact(fine);
    Met met;
    while (delivery->frame() < setup.frames) {
        const auto frame = delivery->advance();
        if (!frame) continue;
        REQUIRE(frame->trouble.empty());
        REQUIRE(exact.advance().trouble.empty());
        met.stated = std::max(met.stated, frame->error_rms);
        met.truth = std::max(met.truth, distance_between(delivery->state().x, exact.state().x).rms);
    }
    CHECK(delivery->error().reached == true);
    met.method = delivery->simulation().method().name;
    met.passes = delivery->error().passes.size();
    return met;
}

}  // namespace

TEST_CASE("stiff cloth to a centimetre goes by projections, and the error stated holds", "[simulate]") {
    const Ways ways = ways_to(stiff(), 1e-2);
    REQUIRE(ways.rough);
    CHECK(ways.rough->method == "xpbd");
    CHECK(seconds_to_judge(*ways.rough) < seconds_to_judge(ways.usual) / 2);
    const Met run = met(stiff(), 1e-2);
    CHECK(run.method == "xpbd");
    CHECK(run.truth <= run.stated);
    CHECK(run.stated <= 1e-2);
}

TEST_CASE("where projections do not get there in time, explicit steps take over", "[simulate]") {
    Setup setup = stiff();
    setup.frames = 25;
    const Met run = met(setup, 1e-3);
    CHECK(run.method == "takahashi_imada");
    CHECK(run.truth <= 1e-3);
}

TEST_CASE("tight tolerances go to a method of higher order, loose ones do not", "[simulate]") {
    Setup setup = swatch(8, 200);
    setup.frames = 4;
    CHECK(met(setup, 1e-4).method == "takahashi_imada");
    const Met tight = met(setup, 1e-11);
    CHECK(tight.method == "srkn6");
    CHECK(tight.truth <= 1e-11);

    Setup damped = scene_of(square(8), full_fabric(), {0, 72});
    damped.frames = 4;
    CHECK(met(damped, 1e-3).method == "verlet");
    const Met fine = met(damped, 1e-7);
    CHECK(fine.method == "rk4");
    CHECK(fine.truth <= 1e-7);
}

TEST_CASE("the method that is asked for is the only way", "[simulate]") {
    Setup setup = stiff();
    setup.method = "verlet";
    const Ways ways = ways_to(setup, 1e-2);
    CHECK(ways.usual.method == "verlet");
    CHECK_FALSE(ways.rough);
    CHECK_FALSE(ways.fine);
    CHECK(ways.usual.because == "asked for");
}

TEST_CASE("beyond what explicit steps can afford, implicit ones are taken without being asked",
          "[simulate]") {
    CHECK(Simulation(swatch(8, 500)).method().name == "takahashi_imada");
    CHECK(Simulation(swatch(8, 1e9)).method().is_implicit());
    Setup forced = swatch(8, 500);
    forced.step = 0.05;
    const Simulation simulation(forced);
    CHECK(simulation.method().is_implicit());
    CHECK(simulation.chosen_because().find("beyond the longest stable one") != std::string::npos);
}
