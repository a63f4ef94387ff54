// Properties every solid in the table has: a new row is held to them by being listed.
#include "obstacle/obstacle.h"

#include <catch2/catch.hpp>

#include "support/obstacles.h"
#include "support/triangle_soup.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("every solid's normal is a unit vector, and the gradient of its distance off the medial axis",
          "[obstacle]") {
    std::mt19937 random(2);
    for (const TestSolid& s : every_solid()) {
        CAPTURE(s.name);
        int on_a_crease = 0;
        for (const Vec3& p : points_around(s, 400, random)) {
            const Vec3 normal = s.solid->sample(p).normal;
            REQUIRE(normal.norm() == Approx(1).epsilon(1e-14));
            const double h = 1e-5;
            Vec3 gradient;
            bool smooth = true;
            for (int c = 0; c < 3; ++c) {
                const SurfaceSample after = s.solid->sample(p + h * Vec3::Unit(c));
                const SurfaceSample before = s.solid->sample(p - h * Vec3::Unit(c));
                gradient[c] = (after.distance - before.distance) / (2 * h);
                smooth = smooth && after.normal.dot(before.normal) > 0.9;
            }
            if (smooth)
                REQUIRE((gradient - normal).norm() < 1e-6);  // measured: 6e-8
            else
                ++on_a_crease;
        }
        CHECK(on_a_crease <= 2);
    }
}

TEST_CASE("every solid's distance falls to zero where its normal says the surface is", "[obstacle]") {
    std::mt19937 random(3);
    for (const TestSolid& s : every_solid()) {
        CAPTURE(s.name);
        for (const Vec3& p : points_around(s, 400, random))
            REQUIRE(std::abs(s.solid->sample(on_surface(*s.solid, p)).distance) < 1e-14);  // measured: 6e-16
    }
}

TEST_CASE("no solid's distance changes by more than the way", "[obstacle]") {
    std::mt19937 random(4);
    for (const TestSolid& s : every_solid()) {
        CAPTURE(s.name);
        const std::vector<Vec3> a = points_around(s, 400, random), b = points_around(s, 400, random);
        for (size_t i = 0; i < a.size(); ++i) {
            const double change = s.solid->sample(a[i]).distance - s.solid->sample(b[i]).distance;
            REQUIRE(std::abs(change) <= (a[i] - b[i]).norm() * (1 + 1e-14));
        }
    }
}

TEST_CASE("every bounded solid's distance is that to its drawn surface, negative inside it", "[obstacle]") {
    std::mt19937 random(5);
    for (const TestSolid& s : every_solid()) {
        if (!s.bounded()) continue;
        CAPTURE(s.name);
        const Mesh surface = s.solid->surface(1);
        const double facets = 1.5e-3;  // how deep they cut; measured: 1.02e-3 m
        int inside = 0;
        for (int i = 0; i < 30; ++i) {
            const auto start =
                static_cast<Eigen::Index>(random() % static_cast<unsigned>(surface.vertices()));
            const Vec3 p = surface.rest.col(start) + 0.2 * s.solid->reach() * random_direction(random);
            const double distance = s.solid->sample(p).distance;
            REQUIRE(std::abs(distance) == Approx(distance_to_triangles(surface, p)).margin(facets));
            if (std::abs(distance) < facets) continue;
            REQUIRE(winding_number(surface, p) == Approx(distance < 0 ? 1 : 0).margin(1e-9));
            inside += distance < 0;
        }
        CHECK(inside > 0);
        CHECK(inside < 30);
    }
}

TEST_CASE("every solid answers at its very centre, axis and ring, where many normals are equally near",
          "[obstacle]") {
    for (const TestSolid& s : every_solid()) {
        CAPTURE(s.name);
        for (const Vec3& axis : {s.shape.axis.normalized(), (s.shape.to - s.shape.from).normalized()}) {
            for (const Vec3& arm : {Vec3(0, 0, 0), axis, axis.unitOrthogonal()}) {
                const Vec3 p = s.solid->centre() + s.shape.radius * arm;
                CHECK(s.solid->sample(p).normal.norm() == Approx(1).epsilon(1e-14));
                CHECK(std::abs(s.solid->sample(on_surface(*s.solid, p)).distance) < 1e-14);
            }
        }
    }
}

TEST_CASE("a bounded solid lies within its reach and comes near it; a plane's reach is infinite",
          "[obstacle]") {
    for (const TestSolid& s : every_solid()) {
        CAPTURE(s.name);
        if (!s.bounded()) {
            CHECK(s.name.starts_with("plane"));
            continue;
        }
        double farthest = 0;
        const Mesh surface = s.solid->surface(1);
        for (int i = 0; i < surface.vertices(); ++i)
            farthest = std::max(farthest, (surface.rest.col(i) - s.solid->centre()).norm());
        CHECK(farthest <= s.solid->reach() * (1 + 1e-12));
        CHECK(farthest > 0.7 * s.solid->reach());  // measured: 0.71
    }
}

TEST_CASE("distances known by hand", "[obstacle]") {
    const auto at = [](std::string_view kind, const ShapeParameters& shape, const Vec3& p) {
        return solid_of(kind, shape)->sample(p).distance;
    };
    ShapeParameters shape;
    shape.centre = Vec3(1, 2, 3);
    shape.normal = Vec3(0, 3, 4);
    CHECK(at("plane", shape, Vec3(1, 2, 8)) == Approx(4));
    shape.radius = 2;
    CHECK(at("sphere", shape, Vec3(1, 6, 6)) == Approx(3));
    shape.from = Vec3(0, 0, 0);
    shape.to = Vec3(4, 0, 0);
    CHECK(at("capsule", shape, Vec3(2, 5, 0)) == Approx(3));
    CHECK(at("capsule", shape, Vec3(7, 4, 0)) == Approx(3));
    shape.size = Vec3(2, 4, 6);
    CHECK(at("box", shape, Vec3(1, 2, 3)) == Approx(-1));
    CHECK(at("box", shape, Vec3(5, 8, 3)) == Approx(5));
    shape.rotate_deg = Vec3(0, 0, 90);
    CHECK(at("box", shape, Vec3(6, 2, 3)) == Approx(3));
    shape.height = 6;
    CHECK(at("cylinder", shape, Vec3(1, 9, 3)) == Approx(4));
    CHECK(at("cylinder", shape, Vec3(1, 9, 8)) == Approx(5));
    shape.radius = 5;
    shape.tube_radius = 1;
    CHECK(at("torus", shape, Vec3(1, 2, 3)) == Approx(4));
    CHECK(at("torus", shape, Vec3(1, 5, 12)) == Approx(4));
}
