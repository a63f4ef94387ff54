// Meshes filled anew.
#include "mesh/remesh.h"

#include <catch2/catch.hpp>

#include "mesh/quality.h"
#include "support/meshes.h"

using namespace drape;

namespace {

MeshQuality quality_of(const Mesh& mesh) {
    return measure_quality(mesh, build_topology(mesh.faces, mesh.vertices()));
}

PatternSize as_it_is() {
    PatternSize size;
    size.columns = size.rows = 0;
    return size;
}

Mesh annulus() {
    PatternSize size{1, 1, 20, 20};
    size.over = "annulus";
    size.hole = 0.3;
    return make_pattern("pseudo_random", size);
}

// rolled onto a cylinder along x
Mesh rolled(Mesh mesh, double radius) {
    for (int v = 0; v < mesh.vertices(); ++v) {
        const double angle = mesh.rest(0, v) / radius;
        mesh.rest.col(v) = Vec3(radius * std::sin(angle), radius * std::cos(angle), mesh.rest(2, v));
    }
    return mesh;
}

std::string trouble(const Mesh& mesh) {
    return error_of([&] { remesh(mesh, "one_way", as_it_is()); });
}

}  // namespace

TEST_CASE("a flat mesh is filled anew by any pattern with its border and edges and UVs", "[mesh]") {
    Mesh old = annulus();
    // UVs of one's own, and a place of one's own
    for (int v = 0; v < old.vertices(); ++v)
        old.drawn.uv.col(v) = Eigen::Vector2f(float(3 * old.rest(0, v) + 1), float(old.rest(2, v) / 2));
    const Mat3 turn = (Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())).toRotationMatrix();
    old.rest = (turn * old.rest).colwise() + Vec3(0.1, 2, -0.3);
    const MeshQuality before = quality_of(old);
    for (const PatternKind& kind : pattern_kinds()) {
        CAPTURE(kind.name);
        const Mesh mesh = remesh(old, kind.name, as_it_is());
        const MeshQuality now = quality_of(mesh);
        CHECK(now.boundary_loops == 2);
        CHECK(now.area == Approx(before.area).epsilon(5e-3));
        CHECK(now.smallest_angle_deg > 20);
        CHECK(now.mean_edge == Approx(before.mean_edge).epsilon(kind.name == "crossed" ? 0.3 : 0.2));
        double off = 0, worst_uv = 0;
        for (int v = 0; v < mesh.vertices(); ++v) {
            const Vec3 p = turn.transpose() * (mesh.rest.col(v) - Vec3(0.1, 2, -0.3));
            off = std::max(off, std::abs(p.y()));
            const Eigen::Vector2f uv(float(3 * p.x() + 1), float(p.z() / 2));
            worst_uv = std::max(worst_uv, double((mesh.drawn.uv.col(v) - uv).norm()));
        }
        CHECK(off < 1e-12);
        CHECK(worst_uv < 1e-5);
        // it faces the side it faced
        const Vec3 a = mesh.rest.col(mesh.faces(0, 0));
        const Vec3 normal = (mesh.rest.col(mesh.faces(1, 0)) - a).cross(mesh.rest.col(mesh.faces(2, 0)) - a);
        CHECK(normal.dot(turn * Vec3::UnitY()) > 0);
    }
}

TEST_CASE("a curved mesh is filled in the plane of its UVs and laid on its surface again", "[mesh]") {
    const Mesh old = rolled(make_pattern("alternating", {1, 0.6, 40, 24}), 0.5);
    const Mesh mesh = remesh(old, "equilateral", as_it_is());
    const MeshQuality now = quality_of(mesh);
    CHECK(now.area == Approx(0.6).epsilon(1e-3));
    CHECK(now.smallest_angle_deg > 20);
    double off = 0;
    for (int v = 0; v < mesh.vertices(); ++v)
        off = std::max(off, std::abs(std::hypot(mesh.rest(0, v), mesh.rest(1, v)) - 0.5));
    CHECK(off < 0.5 * (1 - std::cos(0.025)) + 1e-9);  // chords of the old mesh
    CHECK(mesh.drawn.uv.maxCoeff() == Approx(1));
}

TEST_CASE("a mesh that has no sound place in a plane is refused in a line", "[mesh]") {
    const Mesh sheet = make_pattern("alternating", {1, 1, 6, 6});
    Mesh bare = rolled(sheet, 0.5);
    bare.drawn.uv.resize(2, 0);
    CHECK(trouble(bare) == "it is curved and has no UVs to lay it flat by");
    Mesh stretched = rolled(sheet, 0.5);
    stretched.drawn.uv.row(0) *= 9;
    CHECK_THAT(trouble(stretched), Catch::Contains("its UVs stretch it by 3"));
    Mesh folded = rolled(sheet, 0.5);
    folded.drawn.uv.row(0) = (folded.drawn.uv.row(0).array() - 0.45F).abs();
    CHECK_THAT(trouble(folded), Catch::Contains("its UVs fold over"));
    Mesh pieces = sheet;
    pieces.faces = Faces(pieces.faces(Eigen::all, std::vector<int>{0, 1, 70, 71}));
    pieces.drawn.faces = pieces.faces;
    CHECK_THAT(trouble(pieces), Catch::Contains("pieces"));
    const Faces tetrahedron = faces_of({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    CHECK_THAT(trouble(plain_mesh(points_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), tetrahedron)),
               Catch::Contains("closed"));
}
