#include "mesh/orientation.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace drape;

TEST_CASE("orientation tells the side of a plane to the last bit", "[mesh]") {
    const Vec3 a(0.1, 0.2, 0.3), b(1.7, 0.4, 0.9), c(0.3, 2.1, -0.7);
    const Vec3 inside = (a + b + c) / 3;
    CHECK(orientation(a, b, c, inside + 1e-9 * (b - a).cross(c - a)) == 1);
    CHECK(orientation(a, b, c, inside - 1e-9 * (b - a).cross(c - a)) == -1);
    CHECK(orientation(a, b, c, a) == 0);
    CHECK(orientation(a, b, c, b) == 0);
    CHECK(orientation(a, b, c, Vec3(a + 0.0 * b)) == 0);
    // in a plane x + y + z = 3 of numbers that doubles hold exactly, and one bit off it
    const Vec3 p(1, 1, 1), q(2, 0.5, 0.5), r(0.25, 2.5, 0.25);
    Vec3 s(1.375, 0.5, 1.125);
    CHECK(orientation(p, q, r, s) == 0);
    const int above = orientation(p, q, r, Vec3(3, 3, 3));
    s.z() = std::nextafter(s.z(), 2);
    CHECK(orientation(p, q, r, s) == above);
    s.z() = std::nextafter(std::nextafter(s.z(), 0), 0);
    CHECK(orientation(p, q, r, s) == -above);
    // far from the origin, where plain arithmetic loses the difference
    const Vec3 far(1 << 20, 1 << 21, 1 << 19);
    CHECK(orientation(Vec3(p + far), Vec3(q + far), Vec3(r + far), Vec3(Vec3(1.375, 0.5, 1.125) + far)) == 0);
}

TEST_CASE("orientation changes its sign with any two points' exchange", "[mesh]") {
    for (int i = 0; i < 100; ++i) {
        const auto at = [&](int k) {
            const double t = 0.7 * i + 1.3 * k;
            return Vec3(std::sin(t), std::cos(2 * t), 1e-15 * std::sin(3 * t));
        };
        const int way = orientation(at(0), at(1), at(2), at(3));
        CHECK(orientation(at(1), at(0), at(2), at(3)) == -way);
        CHECK(orientation(at(0), at(2), at(1), at(3)) == -way);
        CHECK(orientation(at(3), at(1), at(2), at(0)) == -way);
    }
}

TEST_CASE("orientation in a plane is exact on a line", "[mesh]") {
    using Eigen::Vector2d;
    CHECK(orientation(Vector2d(0, 0), Vector2d(1, 0), Vector2d(0, 1)) == 1);
    const Vector2d a(0.5, 0.5), b(12, 12), c(24, 24);
    CHECK(orientation(a, b, c) == 0);
    CHECK(orientation(a, b, Vector2d(24, std::nextafter(24.0, 25.0))) == 1);
    CHECK(orientation(Vector2d(std::nextafter(0.5, 0.0), 0.5), b, c) ==
          -orientation(Vector2d(0.5, std::nextafter(0.5, 0.0)), b, c));
}
