#include "mesh/weld.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "mesh/pattern.h"
#include "mesh/topology.h"
#include "support/meshes.h"

using namespace drape;

namespace {

// Two triangles whose shared edge is doubled in the file, with a UV of their own on either side.
TriangleSoup seam() {
    TriangleSoup soup;
    soup.positions = points_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    soup.faces = faces_of({{0, 1, 2}, {3, 4, 5}});
    soup.corner_uv.resize(2, 6);
    soup.corner_uv << 0.0F, 1.0F, 1.0F, 5.0F, 6.0F, 5.0F, 0.0F, 0.0F, 1.0F, 5.0F, 6.0F, 6.0F;
    return soup;
}

double mean_spread(const Faces& faces, int vertices) {
    const Topology topology = build_topology(faces, vertices);
    double sum = 0;
    for (const Edge& edge : topology.edges) sum += edge.vertex[1] - edge.vertex[0];
    return sum / static_cast<double>(topology.edges.size());
}

}  // namespace

TEST_CASE("welding joins a seam's twins for simulation and keeps their UVs for drawing", "[mesh]") {
    const TriangleSoup soup = seam();
    const Mesh mesh = weld(soup).mesh;
    CHECK(mesh.vertices() == 4);
    REQUIRE(mesh.drawn.uv.cols() == 6);
    REQUIRE(mesh.triangles() == 2);
    CHECK(mesh.file_vertex[0] == mesh.file_vertex[3]);
    CHECK(mesh.file_vertex[2] == mesh.file_vertex[4]);
    // every corner is still at its place with its UV
    for (int f = 0; f < 2; ++f) {
        for (int c = 0; c < 3; ++c) {
            const int drawn = mesh.drawn.faces(c, f);
            CHECK(mesh.drawn.vertex[static_cast<size_t>(drawn)] == mesh.faces(c, f));
            bool found = false;
            for (int k = 0; k < 6; ++k)
                found |= soup.corner_uv.col(k) == mesh.drawn.uv.col(drawn) &&
                         soup.positions.col(soup.faces(k % 3, k / 3)) == mesh.rest.col(mesh.faces(c, f));
            CHECK(found);
        }
    }
}

TEST_CASE("welded vertices are spread over the file's again in the file's order", "[mesh]") {
    const TriangleSoup soup = seam();
    const Mesh mesh = weld(soup).mesh;
    CHECK(in_file_order(mesh, mesh.rest) == soup.positions);
}

TEST_CASE("a vertex no triangle uses is not simulated, but keeps its place in the file", "[mesh]") {
    TriangleSoup soup = seam();
    soup.positions.conservativeResize(3, 8);
    soup.positions.col(6) = Vec3(7, 7, 7);
    soup.positions.col(7) = Vec3(1, 0, 0);  // unused too, but where a used one stands
    const WeldResult welded = weld(soup);
    CHECK(welded.unused_vertices == 1);
    CHECK(welded.mesh.file_vertex[6] == -1);
    CHECK(welded.mesh.file_vertex[7] == welded.mesh.file_vertex[1]);
    CHECK(in_file_order(welded.mesh, welded.mesh.rest) == soup.positions);
}

TEST_CASE("triangles without area are dropped and counted: collinear, repeated or welded corners", "[mesh]") {
    TriangleSoup soup;
    soup.positions =
        points_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}, {-0.0, 0, 0}, {3, 0, 0}, {3, 1e-8, 0}});
    soup.faces = faces_of({{0, 1, 2}, {0, 3, 1}, {1, 1, 2}, {0, 4, 2}, {0, 5, 6}});
    const WeldResult welded = weld(soup);
    CHECK(welded.mesh.triangles() == 1);
    CHECK(welded.dropped_zero_area == 4);
    CHECK(welded.mesh.vertices() == 3);
    soup.faces = faces_of({{0, 3, 1}});
    CHECK(weld(soup).mesh.triangles() == 0);
}

TEST_CASE("a thin triangle that is one stays", "[mesh]") {
    TriangleSoup soup;
    soup.positions = points_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-5, 0}});
    soup.faces = faces_of({{0, 1, 2}});
    CHECK(weld(soup).mesh.triangles() == 1);
}

TEST_CASE("however the file shuffles its vertices, neighbours get neighbouring numbers", "[mesh]") {
    const Mesh sheet = make_pattern("alternating", {1, 1, 40, 40});
    std::vector<int> shuffle(static_cast<size_t>(sheet.vertices()));
    for (size_t i = 0; i < shuffle.size(); ++i) shuffle[i] = static_cast<int>(i);
    std::mt19937 random(1);
    std::shuffle(shuffle.begin(), shuffle.end(), random);
    TriangleSoup soup;
    soup.positions.resize(3, sheet.vertices());
    for (int v = 0; v < sheet.vertices(); ++v)
        soup.positions.col(shuffle[static_cast<size_t>(v)]) = sheet.rest.col(v);
    soup.faces = sheet.faces;
    for (int& corner : soup.faces.reshaped()) corner = shuffle[static_cast<size_t>(corner)];

    const Mesh mesh = weld(soup).mesh;
    CHECK(mesh.vertices() == sheet.vertices());
    CHECK(mean_spread(soup.faces, mesh.vertices()) > 400);
    CHECK(mean_spread(mesh.faces, mesh.vertices()) < 41);  // a row of the sheet
    CHECK(in_file_order(mesh, mesh.rest) == soup.positions);
    // nothing lost, nothing twice: every file vertex has its own
    CHECK(std::set<int>(mesh.file_vertex.begin(), mesh.file_vertex.end()).size() == shuffle.size());
}
