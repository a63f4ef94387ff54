#include "simulate/predicted_cost.h"

#include <catch2/catch.hpp>

#include "support/setups.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("the steps foretold are the steps made where contact does not shorten them", "[simulate]") {
    Simulation simulation(swatch(8, 500));
    const PredictedCost cost = predicted_cost(simulation);
    long steps = 0;
    while (simulation.frame() < simulation.frames()) steps += simulation.advance().steps;
    CHECK(cost.steps == Approx(double(steps)).epsilon(0.2));  // the stable step changes with the shape
}

TEST_CASE("more cloth, more forces and stiffer springs cost more", "[simulate]") {
    const auto seconds = [](Setup setup) { return predicted_cost(Simulation(std::move(setup))).seconds; };
    const double plain = seconds(swatch(8, 500));
    CHECK(plain > 0);
    CHECK(seconds(swatch(16, 500)) > 3 * plain);
    CHECK(seconds(swatch(8, 50000)) > 8 * plain);
    Setup rich = swatch(8, 500);
    const Simulation once(std::move(rich));
    // a step of finite elements costs less than one of edges and altitudes
    const auto step = [](MembraneKind kind) {
        Fabric fabric = full_fabric();
        fabric.stretch_model = StretchModel::membrane;
        fabric.membrane = kind;
        const Simulation simulation(scene_of(square(8), fabric));
        const PredictedCost cost = predicted_cost(simulation);
        return cost.seconds / cost.steps;
    };
    CHECK(step(MembraneKind::stvk) < step(MembraneKind::none));
    CHECK(seconds(flag()) / predicted_cost(Simulation(flag())).steps > plain / predicted_cost(once).steps);
}
