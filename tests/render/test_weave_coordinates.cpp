#include "render/weave_coordinates.h"

#include <catch2/catch.hpp>

#include "support/draped_cloth.h"

using namespace drape;

TEST_CASE("weave coordinates measure metres of cloth, with UVs and without", "[render]") {
    Mesh mesh = make_pattern("alternating", {2, 0.5, 8, 4});
    const bool with_uv = GENERATE(true, false);
    if (!with_uv) mesh.drawn.uv.resize(2, 0);
    const DrawnMesh drawn = with_weave_coordinates(mesh);
    for (int f = 0; f < drawn.faces.cols(); ++f)
        for (int c = 0; c < 3; ++c) {
            const int a = drawn.faces(c, f), b = drawn.faces((c + 1) % 3, f);
            const double on_cloth =
                (mesh.rest.col(mesh.faces(c, f)) - mesh.rest.col(mesh.faces((c + 1) % 3, f))).norm();
            CHECK((drawn.uv.col(a) - drawn.uv.col(b)).norm() == Approx(on_cloth).epsilon(1e-4));
        }
}

TEST_CASE("a ball without UVs is projected from its sides, never stretched beyond the diagonal", "[render]") {
    const Mesh mesh = ball(1, 16);
    const DrawnMesh drawn = with_weave_coordinates(mesh);
    REQUIRE(drawn.uv.cols() == static_cast<Eigen::Index>(drawn.vertex.size()));
    for (int f = 0; f < drawn.faces.cols(); ++f) {
        const Vec3 a = mesh.rest.col(mesh.faces(0, f)), b = mesh.rest.col(mesh.faces(1, f)),
                   c = mesh.rest.col(mesh.faces(2, f));
        const Eigen::Vector2f s = drawn.uv.col(drawn.faces(1, f)) - drawn.uv.col(drawn.faces(0, f));
        const Eigen::Vector2f t = drawn.uv.col(drawn.faces(2, f)) - drawn.uv.col(drawn.faces(0, f));
        const double kept = std::abs(s.x() * t.y() - s.y() * t.x()) / (b - a).cross(c - a).norm();
        CHECK(kept > 0.57);  // 1 / sqrt 3 where all three axes are equally near
    }
}

TEST_CASE("the distance from the border of a sheet is exact, and of a closed surface without end",
          "[render]") {
    const Mesh sheet = make_pattern("one_way", {1, 0.6, 10, 6});
    const Eigen::VectorXf distance = border_distance(sheet.rest, sheet.faces);
    for (int v = 0; v < sheet.vertices(); ++v) {
        const Vec3 x = sheet.rest.col(v);
        CHECK(distance[v] == Approx(std::min(0.5 - std::abs(x.x()), 0.3 - std::abs(x.z()))).margin(1e-6));
    }
    const Mesh closed = ball(1, 6);
    CHECK(border_distance(closed.rest, closed.faces, 9).minCoeff() == 9);
}
