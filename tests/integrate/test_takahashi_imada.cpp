#include <algorithm>
#include <catch2/catch.hpp>

#include "support/motion.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("leaving the processed variables undoes entering them, at any stable step", "[integrate]") {
    const Spectrum mode{3.7, 0};
    const Method& method = method_named("takahashi_imada");
    Oscillator spring(mode, 0.4);
    const State start = Oscillator::at({0.7, 0.2, -0.3}, {0.3, -2, 1});
    for (const double share : {0.01, 0.5, 0.99}) {
        const double h = share * method.longest_step(mode);
        State state = start;
        const auto integrator = method.make();
        integrator->begin(spring.dynamics(), state, h);
        CHECK((state.x - start.x).norm() > 1e-6);
        integrator->end(spring.dynamics(), state, h);
        CHECK((state.x - start.x).norm() < 1e-14);
        CHECK((state.v - start.v).norm() < 1e-13);
    }
}

// An inverse that is only nearly one feeds or starves the fast modes a little at every frame; at the frame
// lengths that resonate they grow without bound.
TEST_CASE("frames of any length neither feed nor starve the fastest modes", "[integrate]") {
    const Spectrum mode{3.7, 0};
    const Method& method = method_named("takahashi_imada");
    const double h = 0.9 * method.longest_step(mode);
    for (int steps = 1; steps <= 12; ++steps) {
        Oscillator spring(mode);
        State state = Oscillator::at({1, 0, 0}, {0, 0, 0});
        const auto integrator = method.make();
        double most = 0;
        for (int frame = 0; frame < 500; ++frame) {
            integrator->begin(spring.dynamics(), state, h);
            for (int i = 0; i < steps; ++i) REQUIRE(integrator->step(spring.dynamics(), state, h));
            integrator->end(spring.dynamics(), state, h);
            most = std::max(most, std::abs(state.x(0, 1)));
        }
        CAPTURE(steps);
        CHECK(most < 1.2);
        CHECK(most > 0.8);
    }
}
