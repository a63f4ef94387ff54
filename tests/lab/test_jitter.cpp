#include "lab/jitter.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("a sine's power is found at its frequency and in its mean square", "[lab]") {
    std::vector<double> signal;
    for (int i = 0; i < 512; ++i) signal.push_back(3 * std::sin(2 * std::numbers::pi * 16 * i / 128.0) + 0.5);
    const std::vector<double> density = power_density(signal, 128, 128);
    REQUIRE(density.size() == 65);
    CHECK(density[15] + density[16] + density[17] == Approx(4.5));
    CHECK(density[40] < 1e-20);
    CHECK(std::accumulate(density.begin(), density.end(), 0.0) == Approx(4.5 + 0.25));
}

TEST_CASE("a sheet with the shortest altitudes moves more jerkily than one with blended ones", "[lab]") {
    const Jitter shortest = measure_jitter(AltitudeMode::shortest, 0.5),
                 blend = measure_jitter(AltitudeMode::blend, 0.5);
    const double threshold = 1.1 * std::max(shortest.fastest, blend.fastest);
    CHECK(threshold < jitter_rate / 2);
    CHECK(shortest.power_above(threshold) > 3 * blend.power_above(threshold));
    CHECK(shortest.power > shortest.power_above(threshold));
}
