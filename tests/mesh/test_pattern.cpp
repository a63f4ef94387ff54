#include "mesh/pattern.h"

#include <catch2/catch.hpp>

#include "mesh/topology.h"
#include "support/meshes.h"

using namespace drape;

TEST_CASE("every pattern covers its rectangle once, front side up, in one piece with one border", "[mesh]") {
    for (const PatternKind& kind : pattern_kinds()) {
        CAPTURE(kind.name);
        const PatternSize size{1.5, 0.7, 9, 4};
        const Mesh mesh = make_pattern(kind.name, size);
        double area = 0;
        for (int f = 0; f < mesh.triangles(); ++f) {
            const Vec3 a = mesh.rest.col(mesh.faces(0, f)), b = mesh.rest.col(mesh.faces(1, f)),
                       c = mesh.rest.col(mesh.faces(2, f));
            const Vec3 normal = (b - a).cross(c - a);
            CHECK(normal.y() > 0);
            area += normal.norm() / 2;
        }
        CHECK(area == Approx(1.5 * 0.7).epsilon(1e-12));
        const Topology topology = build_topology(mesh.faces, mesh.vertices());
        CHECK(topology.components == 1);
        CHECK(topology.non_manifold_edges == 0);
        REQUIRE(topology.boundary_loops.size() == 1);
        CHECK(topology.boundary_loops[0].size() == 2 * (9 + 4));
        // Euler: V - E + F = 1 for a disc
        CHECK(mesh.vertices() - static_cast<int>(topology.edges.size()) + mesh.triangles() == 1);
    }
}

TEST_CASE("every pattern's UVs run over the unit square as its vertices run over the rectangle", "[mesh]") {
    for (const PatternKind& kind : pattern_kinds()) {
        CAPTURE(kind.name);
        const PatternSize size{2, 3, 5, 6};
        const Mesh mesh = make_pattern(kind.name, size);
        REQUIRE(mesh.drawn.uv.cols() == mesh.vertices());
        for (int v = 0; v < mesh.vertices(); ++v) {
            const Eigen::Vector2d uv = mesh.drawn.uv.col(v).cast<double>();
            CHECK(uv.minCoeff() >= 0);
            CHECK(uv.maxCoeff() <= 1);
            CHECK(mesh.rest(0, v) == Approx((uv.x() - 0.5) * 2).margin(1e-6));
            CHECK(mesh.rest(2, v) == Approx((uv.y() - 0.5) * 3).margin(1e-6));
        }
    }
}

TEST_CASE("patterns that make no sense are refused", "[mesh]") {
    CHECK(error_of([] { make_pattern("alternatin", {}); }).find("\"alternating\"") != std::string::npos);
    CHECK_FALSE(error_of([] { make_pattern("one_way", {0, 1, 2, 2}); }).empty());
    CHECK_FALSE(error_of([] { make_pattern("one_way", {1, std::nan(""), 2, 2}); }).empty());
    CHECK_FALSE(error_of([] { make_pattern("one_way", {1, INFINITY, 2, 2}); }).empty());
    CHECK_FALSE(error_of([] { make_pattern("one_way", {1, 1, 0, 2}); }).empty());
    CHECK_FALSE(error_of([] { make_pattern("one_way", {1, 1, 2'000'000'000, 2'000'000'000}); }).empty());
}
