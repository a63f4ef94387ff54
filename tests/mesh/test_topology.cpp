#include "mesh/topology.h"

#include <catch2/catch.hpp>

#include "support/meshes.h"

using namespace drape;

TEST_CASE("two triangles share one edge and have one border that follows their orientation", "[mesh]") {
    const Mesh mesh = two_triangles();
    const Topology topology = build_topology(mesh.faces, 4);
    REQUIRE(topology.edges.size() == 5);
    const Edge& shared = topology.edges[1];  // sorted: 01 02 03 12 23
    CHECK(shared.vertex == std::array{0, 2});
    CHECK(shared.face_count == 2);
    CHECK(shared.face == std::array{0, 1});
    CHECK(shared.opposite == std::array{1, 3});
    CHECK(neighbour_across(topology, 0, 1) == 1);
    CHECK(neighbour_across(topology, 0, 0) == -1);
    REQUIRE(topology.boundary_loops.size() == 1);
    CHECK(topology.boundary_loops[0] == std::vector{1, 2, 3, 0});
}

TEST_CASE("the edge opposite a corner holds the other two", "[mesh]") {
    const Mesh mesh = two_triangles();
    const Topology topology = build_topology(mesh.faces, 4);
    for (int f = 0; f < 2; ++f)
        for (int c = 0; c < 3; ++c)
            for (const int end : topology.edges[static_cast<size_t>(topology.face_edges(c, f))].vertex)
                CHECK((end == mesh.faces((c + 1) % 3, f) || end == mesh.faces((c + 2) % 3, f)));
}

TEST_CASE("a Moebius strip has one border although it cannot be oriented", "[mesh]") {
    // a ladder of six rungs, i below and i + 6 above, closed with a twist
    Faces faces(3, 12);
    for (int i = 0; i < 6; ++i) {
        const int low = i, high = i + 6;
        const int next_low = i < 5 ? i + 1 : 6, next_high = i < 5 ? i + 7 : 0;
        faces.col(2 * i) = Eigen::Vector3i(low, next_low, high);
        faces.col(2 * i + 1) = Eigen::Vector3i(high, next_low, next_high);
    }
    const Topology topology = build_topology(faces, 12);
    CHECK(topology.components == 1);
    CHECK(topology.non_manifold_edges == 0);
    REQUIRE(topology.boundary_loops.size() == 1);
    CHECK(topology.boundary_loops[0].size() == 12);
    CHECK(12 - static_cast<int>(topology.edges.size()) + 12 == 0);
}

TEST_CASE("a book of three pages has one edge too many faces and an open border around each page", "[mesh]") {
    const Topology topology = build_topology(faces_of({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}), 5);
    CHECK(topology.non_manifold_edges == 1);
    CHECK(topology.edges[0].face_count == 3);
    CHECK(neighbour_across(topology, 0, 2) == -1);
    REQUIRE(topology.boundary_loops.size() == 3);
    for (const auto& chain : topology.boundary_loops) {
        REQUIRE(chain.size() == 3);
        CHECK(chain.front() + chain.back() == 1);  // from one end of the spine to the other
    }
}

TEST_CASE("loops that touch in a vertex stay apart, and the longest comes first", "[mesh]") {
    const Topology topology = build_topology(faces_of({{0, 1, 2}, {2, 3, 4}, {2, 4, 5}}), 6);
    CHECK(topology.components == 1);
    REQUIRE(topology.boundary_loops.size() == 2);
    CHECK(topology.boundary_loops[0].size() == 4);
    CHECK(topology.boundary_loops[1].size() == 3);
}

TEST_CASE("a closed surface has no border, and separate pieces are counted", "[mesh]") {
    const Faces tetrahedron = faces_of({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    CHECK(build_topology(tetrahedron, 4).boundary_loops.empty());
    Faces both(3, 8);
    both << tetrahedron, tetrahedron.array() + 4;
    const Topology topology = build_topology(both, 8);
    CHECK(topology.components == 2);
    CHECK(topology.component == std::vector{0, 0, 0, 0, 1, 1, 1, 1});
}
