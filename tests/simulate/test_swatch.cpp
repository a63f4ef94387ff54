// The standard swatch, 33 x 33 vertices and 500 N/m, at half a second: drape's first promise is this error.
#include <catch2/catch.hpp>

#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

struct Hung {
    Points x;  // at 0.5 s [m]
    long sweeps;
};

Hung hung(const std::string& method = "", std::optional<double> step = {}) {
    Setup setup = swatch(32, 500);
    setup.method = method;
    setup.step = step;
    Simulation simulation(std::move(setup));
    run(simulation);
    return {simulation.state().x, simulation.dynamics().sweeps()};
}

double rms(const Points& a, const Points& b) {
    return (a - b).norm() / std::sqrt(double(a.cols()));
}

}  // namespace

TEST_CASE("the swatch is right to 0.1 mm at half a second with nothing asked for", "[simulate]") {
    const Points exact = hung("takahashi_imada", 5e-5).x;
    REQUIRE(exact.row(1).minCoeff() < -0.5);  // it fell
    // two methods of different kind agree where both are fine
    CHECK(rms(hung("verlet", 2.5e-5).x, exact) < 1e-5);  // measured 5.9e-6

    const Hung as_is = hung();
    CHECK(rms(as_is.x, exact) < 5e-5);  // measured 2.2e-5
    CHECK(as_is.sweeps < 2500);         // measured 1956
    // order four pays: at their own longest steps, of nearly as many sweeps, the others are 20 and 31 times
    // off
    CHECK(rms(hung("verlet").x, exact) > 5 * rms(as_is.x, exact));
    CHECK(rms(hung("symplectic_euler").x, exact) > 5 * rms(as_is.x, exact));
}
