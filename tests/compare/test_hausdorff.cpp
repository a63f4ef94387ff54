#include "compare/hausdorff.h"

#include <cmath>
#include <random>

#include <catch2/catch.hpp>

using namespace drape;

namespace {

Points random_points(int count, unsigned seed) {
    std::minstd_rand random(seed);
    Points points(3, count);
    for (int i = 0; i < count; ++i)
        for (int c = 0; c < 3; ++c) points(c, i) = static_cast<double>(random() % 1000) / 1000;
    return points;
}

// every point against every other
double plainly(const Points& a, const Points& b) {
    double most = 0;
    for (int i = 0; i < a.cols(); ++i)
        most = std::max(most, (b.colwise() - a.col(i)).colwise().norm().minCoeff());
    return most;
}

}  // namespace

TEST_CASE("Hausdorff's distance is that of all pairs tried whichever set is first", "[compare]") {
    const auto seed = GENERATE(1U, 2U, 3U);
    const Points a = random_points(200, seed), b = random_points(150, seed + 10);
    const double expected = std::max(plainly(a, b), plainly(b, a));
    CHECK(hausdorff_distance(a, b) == Approx(expected));
    CHECK(hausdorff_distance(b, a) == Approx(expected));
}

TEST_CASE("Hausdorff's distance does not mind which vertex stands where", "[compare]") {
    const Points a = random_points(50, 4);
    const Points turned = a.rowwise().reverse();
    CHECK(hausdorff_distance(turned, a) == 0);
    Points moved = turned;
    moved.col(7).y() += 3;
    CHECK(hausdorff_distance(moved, a) > 2);
}

TEST_CASE("nothing is infinitely far from something and so is what is not a number", "[compare]") {
    const Points none(3, 0);
    Points broken = random_points(5, 6);
    CHECK(hausdorff_distance(none, none) == 0);
    CHECK(std::isinf(hausdorff_distance(none, broken)));
    broken(1, 3) = std::nan("");
    CHECK(std::isinf(hausdorff_distance(broken, random_points(5, 6))));
}
