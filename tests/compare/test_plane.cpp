#include "compare/plane.h"

#include <numeric>

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("a filter weighs columns and rows as its two halves say", "[compare]") {
    Plane plane(5, 4, 2);
    for (int y = -2; y < 6; ++y)
        for (int x = -2; x < 7; ++x) plane.row(y)[x] = static_cast<float>(x * x + 10 * y);
    const std::vector<float> second{1, -2, 1}, mean{0.2F, 0.2F, 0.2F, 0.2F, 0.2F}, one{1};
    const Plane curved = filtered(plane, second, mean), as_it_was = filtered(plane, one, one);
    CHECK(curved.margin == 0);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 5; ++x) {
            CHECK(curved.row(y)[x] == Approx(2).margin(1e-4));
            CHECK(as_it_was.row(y)[x] == plane.row(y)[x]);
        }
    }
    const Plane uneven = filtered(plane, {std::vector<float>{0, 0, 1}}, one);
    CHECK(uneven.row(1)[2] == plane.row(1)[3]);
}

TEST_CASE("a Gaussian's weights are even and sum to one", "[compare]") {
    const std::vector<float> weights = gaussian(1.5, 5);
    REQUIRE(weights.size() == 11);
    CHECK(std::accumulate(weights.begin(), weights.end(), 0.0) == Approx(1));
    CHECK(weights[2] == weights[8]);
    CHECK(weights[6] / weights[5] == Approx(std::exp(-1 / 4.5)));
}
