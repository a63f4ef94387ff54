#include "mesh/delaunay.h"

#include <catch2/catch.hpp>

#include "mesh/pattern.h"
#include "support/meshes.h"

using namespace drape;

namespace {

// Over 0 where d lies inside the circle through a, b, c, which turn left; times the fourth power of lengths.
double inside_circle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                     const Eigen::Vector2d& d) {
    Mat3 m;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector2d to = (i == 0 ? a : i == 1 ? b : c) - d;
        m.row(i) << to.x(), to.y(), to.squaredNorm();
    }
    return m.determinant();
}

void check_delaunay(const Eigen::Matrix2Xd& points, const Eigen::Matrix3Xi& faces) {
    double worst = 0;
    for (int f = 0; f < faces.cols(); ++f)
        for (int v = 0; v < points.cols(); ++v)
            worst = std::max(worst, inside_circle(points.col(faces(0, f)), points.col(faces(1, f)),
                                                  points.col(faces(2, f)), points.col(v)));
    CHECK(worst < 1e-12);  // measured: 1e-17, four points on one circle
}

}  // namespace

TEST_CASE("no point of a Delaunay triangulation lies in a triangle's circumcircle", "[mesh]") {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Mesh mesh = make_pattern("pseudo_random", {1, 1, 16, 16, seed});
        Eigen::Matrix2Xd points(2, mesh.vertices());
        points.row(0) = mesh.rest.row(0);
        points.row(1) = mesh.rest.row(2);
        check_delaunay(points, delaunay(points));
    }
}

TEST_CASE("points of a grid, four on every circle, still make a whole triangulation", "[mesh]") {
    Eigen::Matrix2Xd points(2, 25);
    for (int i = 0; i < 25; ++i) points.col(i) = Eigen::Vector2d(0.1 * (i % 5), 0.1 * (i / 5));
    const Eigen::Matrix3Xi faces = delaunay(points);
    CHECK(faces.cols() == 32);
    check_delaunay(points, faces);
    CHECK(delaunay(points.leftCols(7)(Eigen::all, {0, 1, 5, 6})).cols() == 2);  // all on one circle
}

TEST_CASE("points that span no plane are refused", "[mesh]") {
    Eigen::Matrix2Xd line(2, 4);
    line << 0, 1, 2, 3, 0, 1, 2, 3;
    CHECK(error_of([&] { delaunay(line); }).find("cannot triangulate 4 points") == 0);
    CHECK_FALSE(error_of([&] { delaunay(line.leftCols(2)); }).empty());
    Eigen::Matrix2Xd twins(2, 4);
    twins << 0, 1, 0, 0, 0, 0, 1, 1;
    CHECK_FALSE(error_of([&] { delaunay(twins); }).empty());
}
