#include <catch2/catch.hpp>

#include "support/motion.h"
#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

// How far two ends are apart, RMS over the vertices [m].
double distance(const State& a, const State& b) {
    return std::sqrt((a.x - b.x).colwise().squaredNorm().mean());
}

}  // namespace

TEST_CASE("projective dynamics goes where backward Euler goes, with one factorisation", "[integrate]") {
    for (const double h : {1e-3, 5e-3, 2e-2}) {
        const Setup setup = flag(6);
        Dynamics dynamics(setup.model, forces_of(setup.model, setup.world), nullptr);
        constexpr double end = 0.2;
        const auto steps = static_cast<int>(std::lround(end / h));
        const State exact = integrated(method_named("backward_euler"), dynamics, setup.start, end, steps);
        const State finer = integrated(method_named("backward_euler"), dynamics, setup.start, end, 2 * steps);
        State state = setup.start;
        const auto integrator = method_named("projective_dynamics").make();
        integrator->begin(dynamics, state, h);
        for (int i = 0; i < steps; ++i) REQUIRE(integrator->step(dynamics, state, h));
        CAPTURE(h, integrator->work().iterations, distance(exact, finer));
        CHECK(distance(state, exact) < 0.01 * distance(exact, finer));  // measured 0.3e-3 to 3.1e-3
        CHECK(integrator->work().factorisations == 1);
    }
}

TEST_CASE("springs of 1e9 N/m stay bounded under projective dynamics at steps of any length", "[integrate]") {
    for (const auto& [step, frame_rate] : {std::pair(1e-4, 120.0), {2e-3, 30.0}, {1 / 30.0, 30.0}}) {
        Setup setup = swatch(3, 1e9);
        setup.method = "projective_dynamics";
        setup.step = step;
        setup.frame_rate = frame_rate;
        setup.frames = 1;
        Simulation simulation(std::move(setup));
        const double energy = simulation.energies().total();
        while (simulation.frame() < simulation.frames()) {
            const FrameReport report = simulation.advance();
            CAPTURE(step, report.index, report.trouble, report.steps);
            REQUIRE(report.trouble.empty());
            CHECK(simulation.energies().total() < energy + 1e-3);  // measured 9e-5 J at the shortest step
            CHECK(report.strain < 1e-3);
        }
    }
}
