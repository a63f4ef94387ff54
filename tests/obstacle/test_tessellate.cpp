#include "obstacle/tessellate.h"

#include <catch2/catch.hpp>
#include <set>

#include "support/obstacles.h"

using namespace drape;
using namespace drape::test;

namespace {

struct Triangle {
    Vec3 a, b, c;
    Vec3 centre() const { return (a + b + c) / 3; }
    Vec3 normal() const { return (b - a).cross(c - a).normalized(); }
};

Triangle triangle(const Mesh& mesh, int f) {
    return {mesh.rest.col(mesh.faces(0, f)), mesh.rest.col(mesh.faces(1, f)),
            mesh.rest.col(mesh.faces(2, f))};
}

// Every edge is walked once each way, by two triangles.
bool is_closed_and_oriented(const Mesh& mesh) {
    std::set<std::pair<int, int>> walked;
    for (int f = 0; f < mesh.triangles(); ++f)
        for (int k = 0; k < 3; ++k)
            if (!walked.insert({mesh.faces(k, f), mesh.faces((k + 1) % 3, f)}).second) return false;
    return std::all_of(walked.begin(), walked.end(), [&](const auto& edge) {
        return walked.contains({edge.second, edge.first});
    });
}

}  // namespace

TEST_CASE("every drawn vertex lies on the solid's surface and every triangle near it, facing out",
          "[obstacle]") {
    for (const TestSolid& s : every_solid()) {
        CAPTURE(s.name);
        const Mesh mesh = s.solid->surface(2);
        REQUIRE(mesh.triangles() > 0);
        for (int i = 0; i < mesh.vertices(); ++i)
            REQUIRE(std::abs(s.solid->sample(mesh.rest.col(i)).distance) < 1e-14);  // measured: 4e-16
        for (int f = 0; f < mesh.triangles(); ++f) {
            const Triangle t = triangle(mesh, f);
            const SurfaceSample below = s.solid->sample(t.centre());
            REQUIRE(std::abs(below.distance) < 2e-3);      // measured: 1.1e-3 m
            REQUIRE(t.normal().dot(below.normal) > 0.99);  // measured: 0.997
        }
    }
}

TEST_CASE("every bounded solid's drawn surface is closed and encloses a volume; a plane's is a square",
          "[obstacle]") {
    for (const TestSolid& s : every_solid()) {
        CAPTURE(s.name);
        const Mesh mesh = s.solid->surface(2);
        CHECK(is_closed_and_oriented(mesh) == s.bounded());
        double volume = 0, area = 0;
        for (int f = 0; f < mesh.triangles(); ++f) {
            const Triangle t = triangle(mesh, f);
            volume += t.a.dot(t.b.cross(t.c)) / 6;
            area += (t.b - t.a).cross(t.c - t.a).norm() / 2;
        }
        if (s.bounded())
            CHECK(volume > 0);
        else
            CHECK(area == Approx(4));
    }
}

TEST_CASE("drawn spheres, boxes, cylinders and rings have the volume geometry gives them", "[obstacle]") {
    ShapeParameters shape;
    shape.centre = Vec3(0.2, -0.1, 0.4);
    shape.axis = Vec3(1, 2, -1);
    shape.rotate_deg = Vec3(20, 30, 40);
    shape.radius = 0.5;
    shape.tube_radius = 0.2;
    shape.size = Vec3(1, 2, 3);
    shape.height = 2;
    const double pi = std::numbers::pi;
    const std::pair<std::string_view, double> expected[] = {
        {"sphere", 4 * pi / 3 * 0.125}, {"box", 6}, {"cylinder", pi * 0.25 * 2}, {"torus", pi * pi * 0.04}};
    for (const auto& [kind, volume] : expected) {
        CAPTURE(kind);
        const Mesh mesh = solid_of(kind, shape)->surface(1);
        double sum = 0;
        for (int f = 0; f < mesh.triangles(); ++f) {
            const Triangle t = triangle(mesh, f);
            sum += t.a.dot(t.b.cross(t.c)) / 6;
        }
        CHECK(sum == Approx(volume).epsilon(5e-3));  // measured: 0.33 % lost to facets
    }
}
