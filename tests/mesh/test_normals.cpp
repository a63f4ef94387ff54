#include "mesh/normals.h"

#include <catch2/catch.hpp>

#include "support/draped_cloth.h"

using namespace drape;

TEST_CASE("normals of a ball point away from its centre", "[mesh]") {
    const Mesh mesh = ball(2, 16);
    const Points normals = vertex_normals(mesh.rest, mesh.faces);
    for (int v = 0; v < mesh.vertices(); ++v)
        CHECK((normals.col(v) - mesh.rest.col(v) / 2).norm() < 1e-9);  // exact on a sphere
}

TEST_CASE("a roof keeps its sharp ridge and smooths a gentle one", "[mesh]") {
    const double rise = GENERATE(0.1, 1.0);
    Points x(3, 4);
    x << 0, 0, 1, -1, rise, rise, 0, 0, 0, 1, 0, 0;
    Faces faces(3, 2);
    faces << 0, 0, 1, 3, 2, 1;
    const Points corner = corner_normals(x, faces, 40);
    const bool smooth = (corner.col(0) - corner.col(3)).norm() < 1e-12;
    CHECK(smooth == (rise < 0.5));
    CHECK(corner.col(0).y() > 0.5);
}

TEST_CASE("a vertex without area around it gets a unit normal, not a NaN", "[mesh]") {
    Points x = Points::Zero(3, 3);
    Faces faces(3, 1);
    faces << 0, 1, 2;
    CHECK(vertex_normals(x, faces).col(0) == Vec3::UnitY());
}
