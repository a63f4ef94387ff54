// What every symmetric splitting of fractions that sum to 1 must do, whatever its order.
#include <catch2/catch.hpp>

#include "support/motion.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("a step forward and a step back lead to the start", "[integrate]") {
    for (const char* name : {"srkn4", "srkn6"}) {
        Oscillator spring({3.7, 0}, 0.4);
        const State start = Oscillator::at({0.7, 0.2, -0.3}, {0.3, -2, 1});
        State state = start;
        for (const double h : {0.5, -0.5}) {
            const auto integrator = method_named(name).make();
            integrator->begin(spring.dynamics(), state, h);
            REQUIRE(integrator->step(spring.dynamics(), state, h));
        }
        CAPTURE(name);
        CHECK((state.x - start.x).norm() < 1e-14);
        CHECK((state.v - start.v).norm() < 1e-13);
        CHECK(std::abs(state.time) < 1e-16);
    }
}

TEST_CASE("free fall is exact: kicks sum to 1, drifts to 1, and their moments to one half", "[integrate]") {
    for (const char* name : {"srkn4", "srkn6"}) {
        const Model model = model_of(square(1), bare_springs(0));
        Dynamics dynamics(model, forces_of(model, {}), nullptr);
        State state{model.cloths[0].mesh.rest, Points::Zero(3, 4), 0};
        state = integrated(method_named(name), dynamics, state, 0.5, 1);
        CAPTURE(name);
        CHECK((state.v.row(1).array() + 9.81 * 0.5).abs().maxCoeff() < 1e-14);
        CHECK((state.x.row(1).array() + 9.81 * 0.125).abs().maxCoeff() < 1e-14);
    }
}
