#include "mesh/quality.h"

#include <catch2/catch.hpp>

#include "mesh/pattern.h"
#include "support/meshes.h"

using namespace drape;

namespace {

MeshQuality quality_of(const Mesh& mesh) {
    return measure_quality(mesh, build_topology(mesh.faces, mesh.vertices()));
}

}  // namespace

TEST_CASE("the quality of a unit square of two triangles is what geometry says", "[mesh]") {
    const MeshQuality quality = quality_of(two_triangles());
    CHECK(quality.vertices == 4);
    CHECK(quality.edges == 5);
    CHECK(quality.triangles == 2);
    CHECK(quality.components == 1);
    CHECK(quality.boundary_loops == 1);
    CHECK(quality.area == Approx(1));
    CHECK(quality.shortest_edge == Approx(1));
    CHECK(quality.longest_edge == Approx(std::sqrt(2.0)));
    CHECK(quality.mean_edge == Approx((4 + std::sqrt(2.0)) / 5));
    CHECK(quality.smallest_angle_deg == Approx(45));
    CHECK(quality.largest_aspect == Approx(2));  // sqrt 2 over its height sqrt 1/2
    CHECK(quality.slivers == 0);
}

TEST_CASE("the step cost is one on a mesh where all vertices are alike", "[mesh]") {
    const Mesh tetrahedron = plain_mesh(points_of({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}),
                                        faces_of({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
    CHECK(quality_of(tetrahedron).step_cost == Approx(1));
    CHECK(quality_of(make_pattern("one_way", {1, 1, 20, 20})).step_cost < 1.3);
}

TEST_CASE("one sliver is found, counted and charged: halving its height costs twice the steps", "[mesh]") {
    const auto with_height = [](double height) {
        Mesh mesh = make_pattern("one_way", {1, 1, 10, 10});
        // an inner vertex comes close to the edge below it
        const int v = 5 * 11 + 5;
        mesh.rest.col(v) = mesh.rest.col(v - 11) + Vec3(0.03, 0, height);
        return mesh;
    };
    const MeshQuality thin = quality_of(with_height(1e-3)), thinner = quality_of(with_height(5e-4));
    CHECK(thin.slivers > 0);
    CHECK(thin.worst_triangle >= 0);
    CHECK(thin.smallest_angle_deg < 3);
    CHECK(thin.step_cost > 5);
    CHECK(thinner.step_cost > 1.3 * thin.step_cost);  // the mass of its neighbours shares the blame
}
