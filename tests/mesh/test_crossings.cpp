#include "mesh/crossings.h"

#include <catch2/catch.hpp>

#include "mesh/pattern.h"
#include "support/meshes.h"

using namespace drape;

namespace {

// A triangle in the floor and another one.
int crossings_with(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Points x = points_of({{0, 0, 0}, {4, 0, 0}, {0, 0, 4}, a, b, c});
    const Faces faces = faces_of({{0, 1, 2}, {3, 4, 5}});
    const Crossings found = count_crossings(faces, x);
    CHECK(found.triangles == 2 * found.pairs);
    CHECK(found.crosses == std::vector<bool>(2, found.pairs == 1));
    return found.pairs;
}

Mesh sheet(int divisions) {
    return make_pattern("alternating", {1, 1, divisions, divisions, 1});
}

}  // namespace

TEST_CASE("triangles that pierce or touch each other cross and others do not", "[mesh]") {
    CHECK(crossings_with({1, -1, 1}, {1, 1, 1}, {2, 1, 1}) == 1);     // an edge goes through
    CHECK(crossings_with({-1, -1, 1}, {5, -1, 1}, {1, 3, 1}) == 1);   // only the other's edges go through
    CHECK(crossings_with({1, 1e-12, 1}, {1, 1, 1}, {2, 1, 1}) == 0);  // just above
    CHECK(crossings_with({1, 0, 1}, {1, 1, 1}, {2, 1, 1}) == 1);      // a corner touches
    CHECK(crossings_with({3, -1, 3}, {3, 1, 3}, {5, 1, 5}) == 0);     // through its plane beside it
    CHECK(crossings_with({4, -1, 0}, {4, 1, 0}, {5, 1, 0}) == 1);     // an edge touches a corner
    CHECK(crossings_with({1, 0, 1}, {1.5, 0, 1}, {1, 0, 1.5}) == 1);  // in its plane and inside
    CHECK(crossings_with({-1, 0, -1}, {9, 0, -1}, {-1, 0, 9}) == 1);  // in its plane and around
    CHECK(crossings_with({3, 0, 3}, {5, 0, 3}, {3, 0, 5}) == 0);      // in its plane and beside
    CHECK(crossings_with({4, 0, 0}, {6, 0, 0}, {4, 0, -2}) == 1);     // in its plane at a corner
}

TEST_CASE("triangles with a common corner cross where either's far side meets the other", "[mesh]") {
    const Points x =
        points_of({{0, 0, 0}, {4, 0, 0}, {0, 0, 4}, {3, -1, 1}, {3, 1, 1}, {-3, 1, 1}, {-3, -1, 1}});
    CHECK(count_crossings(faces_of({{0, 1, 2}, {0, 3, 4}}), x).pairs == 1);
    CHECK(count_crossings(faces_of({{0, 1, 2}, {0, 5, 6}}), x).pairs == 0);
    // with a common edge there is nothing to find
    CHECK(count_crossings(faces_of({{0, 1, 2}, {0, 1, 3}}), x).pairs == 0);
}

TEST_CASE("a sheet laid flat or rolled up does not cross itself and one pulled through itself does",
          "[mesh]") {
    const Mesh mesh = sheet(12);
    CHECK(count_crossings(mesh.faces, mesh.rest).pairs == 0);
    Points x = mesh.rest;
    const auto roll = [&](double radius, double growth) {
        for (int i = 0; i < x.cols(); ++i) {
            const double angle = 9 * (mesh.rest(0, i) + 0.5), r = radius + growth * angle;
            x.col(i) = Vec3(r * std::cos(angle), r * std::sin(angle), mesh.rest(2, i));
        }
        return count_crossings(mesh.faces, x);
    };
    CHECK(roll(0.1, 0.02).pairs == 0);
    const Crossings through = roll(0.18, -0.00001);
    CHECK(through.pairs > 20);
    CHECK(through.triangles > 20);
    CHECK(through.first[0] < through.first[1]);
}

TEST_CASE("the count is that of looking at all pairs and holds where positions are no numbers", "[mesh]") {
    const Mesh mesh = sheet(5);
    std::srand(3);
    Points x = mesh.rest + 0.4 * Points::Random(3, mesh.vertices());
    int pairs = 0;
    for (int i = 0; i < mesh.triangles(); ++i)
        for (int j = i + 1; j < mesh.triangles(); ++j) {
            Faces two(3, 2);
            two << mesh.faces.col(i), mesh.faces.col(j);
            pairs += count_crossings(two, x).pairs;
        }
    CHECK(pairs > 20);
    CHECK(count_crossings(mesh.faces, x).pairs == pairs);
    x(0, 7) = NAN;
    CHECK(count_crossings(mesh.faces, x).pairs < pairs);
    CHECK(count_crossings(Faces(3, 0), x).pairs == 0);
}
