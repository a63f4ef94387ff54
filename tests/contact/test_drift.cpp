#include "contact/drift.h"

#include <catch2/catch.hpp>

#include "support/cloths.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("drift bounds how much any distance changed and a common motion is none", "[contact]") {
    const Points from = random_points(9, 1, 1);
    Drift drift({{1, 3}, {5, 4}});
    drift.begin(from);
    Points x = from;
    x.colwise() += Vec3(3, -1, 2);
    CHECK(drift.at(x) < 1e-14);
    const Points v = random_points(9, 0.3, 2);
    x += random_points(9, 0.1, 3);
    const auto change = [&](const Points& to) {
        double most = 0;
        for (const int i : {1, 2, 3, 5, 6, 7, 8})
            for (const int j : {1, 2, 3, 5, 6, 7, 8})
                most = std::max(
                    most, std::abs((to.col(i) - to.col(j)).norm() - (from.col(i) - from.col(j)).norm()));
        return most;
    };
    CHECK(drift.at(x) >= change(x));
    CHECK(drift.at(x) + 2 * drift.of(v) >= change(x + 2 * v));
    // the others do not count
    x.col(0).setConstant(100);
    x.col(4).setConstant(-100);
    CHECK(drift.at(x) < 1);
}
