#include "mesh/pattern.h"

#include <catch2/catch.hpp>

#include "mesh/quality.h"
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
        if (kind.on_grid || kind.name == "crossed") CHECK(topology.boundary_loops[0].size() == 2 * (9 + 4));
        // the border is the rectangle's, straight to the last bit
        for (const int v : topology.boundary_loops[0]) {
            const Vec3 p = mesh.rest.col(v);
            CHECK((std::abs(p.x()) == 0.75 || std::abs(p.z()) == 0.35));
        }
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
    CHECK_FALSE(error_of([] { make_pattern("crossed", {1, 1, 4000, 4000}); }).empty());
    CHECK_FALSE(error_of([] { make_pattern("equilateral", {1e-9, 1, 32, 32}); }).empty());
    CHECK_FALSE(error_of([] { make_pattern("pseudo_random", {1e-12, 1e3, 32, 32}); }).empty());
}

TEST_CASE("patterns as coarse and as long as can be are whole meshes too", "[mesh]") {
    for (const PatternKind& kind : pattern_kinds()) {
        for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 2}, {2, 1}, {1, 30}, {30, 1}, {3, 7}}) {
            for (const double depth : {0.01, 1.0, 20.0}) {
                CAPTURE(kind.name, columns, rows, depth);
                const Mesh mesh = make_pattern(kind.name, {1, depth, columns, rows});
                const Topology topology = build_topology(mesh.faces, mesh.vertices());
                const MeshQuality quality = measure_quality(mesh, topology);
                CHECK(quality.area == Approx(depth).epsilon(1e-9));
                CHECK(quality.components == 1);
                CHECK(quality.boundary_loops == 1);
                CHECK(quality.non_manifold_edges == 0);
                CHECK(quality.vertices - quality.edges + quality.triangles == 1);
            }
        }
    }
}

TEST_CASE("equilateral triangles are equilateral but for what the rows must give to fit", "[mesh]") {
    const Mesh mesh = make_pattern("equilateral", {1, 1, 32, 32});
    int equilateral = 0;
    double longest = 0, shortest = 1;
    for (int f = 0; f < mesh.triangles(); ++f) {
        Eigen::Vector3d side;
        for (int k = 0; k < 3; ++k)
            side[k] = (mesh.rest.col(mesh.faces(k, f)) - mesh.rest.col(mesh.faces((k + 1) % 3, f))).norm();
        if (side.maxCoeff() > 1.3 * side.minCoeff()) continue;  // halves, at the sides
        ++equilateral;
        longest = std::max(longest, side.maxCoeff());
        shortest = std::min(shortest, side.minCoeff());
    }
    CHECK(equilateral == mesh.triangles() - 2 * 37);
    CHECK(longest / shortest < 1.002);  // measured: 1.001; 37 rows where 36.95 would fit
}

TEST_CASE("pseudo-random vertices are as many as asked, its triangles well shaped, and its seed tells",
          "[mesh]") {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        CAPTURE(seed);
        const Mesh mesh = make_pattern("pseudo_random", {1, 1, 32, 32, seed});
        const MeshQuality quality = measure_quality(mesh, build_topology(mesh.faces, mesh.vertices()));
        CHECK(quality.vertices == Approx(33 * 33).epsilon(0.05));
        CHECK(quality.slivers == 0);
        CHECK(quality.smallest_angle_deg > 20);
        CHECK(quality.step_cost < 1.8);  // measured: 1.63
    }
    const Mesh one = make_pattern("pseudo_random", {1, 1, 16, 16, 1}),
               again = make_pattern("pseudo_random", {1, 1, 16, 16, 1}),
               other = make_pattern("pseudo_random", {1, 1, 16, 16, 2});
    CHECK(one.rest == again.rest);
    CHECK(one.faces == again.faces);
    CHECK((one.vertices() != other.vertices() || one.rest != other.rest));
}
