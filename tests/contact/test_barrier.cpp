#include "contact/barrier.h"

#include <catch2/catch.hpp>

using namespace drape;

namespace {

constexpr Barrier barrier{.thickness = 2e-3, .strength = 50};

double slope(double (Barrier::*f)(double) const, double gap) {
    const double h = 1e-5 * gap;
    const auto at = [&](double offset) { return (barrier.*f)(gap + offset); };
    return (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
}

}  // namespace

TEST_CASE("the barrier's pressure is minus the slope of its energy, its stiffness minus that of its pressure",
          "[contact]") {
    for (double u = 1e-4; u < 0.999; u = u < 0.1 ? 1.7 * u : u + 0.037) {
        const double gap = u * barrier.thickness;
        CAPTURE(u);
        CHECK(barrier.pressure(gap) == Approx(-slope(&Barrier::energy, gap)).epsilon(1e-7));
        CHECK(barrier.stiffness(gap) == Approx(-slope(&Barrier::pressure, gap)).epsilon(1e-7));
        CHECK(barrier.pressure(gap) > 0);
        CHECK(barrier.stiffness(gap) > 0);
    }
}

TEST_CASE("the barrier's energy, pressure and stiffness all start from zero at its thickness", "[contact]") {
    // just inside, as 1 - u = e: energy P d e^3 / 3, pressure P e^2, stiffness 2 P e / d
    const double e = 1e-4, gap = (1 - e) * barrier.thickness;
    CHECK(barrier.energy(gap) == Approx(barrier.strength * barrier.thickness * e * e * e / 3).epsilon(1e-3));
    CHECK(barrier.pressure(gap) == Approx(barrier.strength * e * e).epsilon(1e-3));
    CHECK(barrier.stiffness(gap) == Approx(2 * barrier.strength * e / barrier.thickness).epsilon(1e-3));
    for (const double outside : {1.0, 1.0 + 1e-15, 2.0, 1e6}) {
        CHECK(barrier.energy(outside * barrier.thickness) == 0);
        CHECK(barrier.pressure(outside * barrier.thickness) == 0);
        CHECK(barrier.stiffness(outside * barrier.thickness) == 0);
    }
}

TEST_CASE("no finite energy reaches the surface", "[contact]") {
    CHECK(barrier.energy(0) == INFINITY);
    CHECK(barrier.energy(-1e-3) == INFINITY);
    // half as near costs twice as much
    for (double gap = 1e-9; gap > 1e-300; gap /= 10)
        REQUIRE(barrier.energy(gap / 2) == Approx(2 * barrier.energy(gap)).epsilon(1e-4));
}

TEST_CASE("the barrier presses as asked at the gap it gives", "[contact]") {
    for (const double pressure : {0.0, 1e-3, 1.0, 50.0, 1e6})
        CHECK(barrier.pressure(barrier.gap_under(pressure)) == Approx(pressure).margin(1e-12));
    CHECK(barrier.gap_under(0) == barrier.thickness);
}
