#include "contact/drift.h"

#include <catch2/catch.hpp>

#include "base/rigid_motion.h"
#include "support/cloths.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("drift bounds how much any distance changed and a common motion is none", "[contact]") {
    const Points from = random_points(9, 1, 1);
    Drift drift({{1, 3}, {5, 4}});
    drift.begin(from);
    Points x = from;
    x.colwise() += Vec3(3, -1, 2);
    CHECK(drift.is_within(x, 1e-14));
    const Points v = random_points(9, 0.3, 2);
    x += random_points(9, 0.1, 3);
    const auto change = [&](const Points& then, const Points& to) {
        double most = 0;
        for (const int i : {1, 2, 3, 5, 6, 7, 8})
            for (const int j : {1, 2, 3, 5, 6, 7, 8})
                most = std::max(
                    most, std::abs((to.col(i) - to.col(j)).norm() - (then.col(i) - then.col(j)).norm()));
        return most;
    };
    CHECK_FALSE(drift.is_within(x, 0.999 * change(from, x)));
    CHECK(drift.is_within(x, 0.4));
    CHECK(drift.of(v) >= change(x, x + v));
    // the others do not count
    x.col(0).setConstant(100);
    x.col(4).setConstant(-100);
    CHECK(drift.is_within(x, 0.4));
}

TEST_CASE("what turns as one body does not drift", "[contact]") {
    const Points from = random_points(600, 1, 1);
    Drift drift({{0, 600}});
    drift.begin(from);
    const Mat3 turn = rotation_from_degrees(Vec3(20, 130, -50));
    Points x = (turn * from).colwise() + Vec3(3, -1, 2);
    CHECK(drift.is_within(x, 1e-13));
    x += random_points(600, 0.01, 4);
    CHECK(drift.is_within(x, 0.04));
    CHECK_FALSE(drift.is_within(x, 0.01));

    const Vec3 angular(2, -1, 4);
    Points v(3, 600);
    for (int i = 0; i < 600; ++i) v.col(i) = Vec3(5, 0, 1) + angular.cross(x.col(i));
    CHECK(drift.rate(x, v) < 1e-12);
    v += random_points(600, 0.1, 5);
    CHECK(drift.rate(x, v) < 0.4);
    double fastest = 0;
    for (int i = 0; i < 600; ++i)
        for (int j = 0; j < i; ++j)
            fastest = std::max(fastest, -(x.col(i) - x.col(j)).normalized().dot(v.col(i) - v.col(j)));
    CHECK(drift.rate(x, v) >= fastest);
}

TEST_CASE("drift of points on a line or in one place is bounded too", "[contact]") {
    Points from = Points::Zero(3, 4);
    Drift drift({{0, 4}});
    drift.begin(from);
    CHECK(drift.is_within(from, 0));
    CHECK(drift.rate(from, Points::Ones(3, 4)) == 0);
    Points x = from;
    x.row(0) << 0, 1, 2, 3;
    CHECK_FALSE(drift.is_within(x, 2.9));
    CHECK(drift.rate(x, random_points(4, 1, 3)) >= 0);
    x(1, 2) = NAN;
    CHECK_FALSE(drift.is_within(x, 2.9));
}
