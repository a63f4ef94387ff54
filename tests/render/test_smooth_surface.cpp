#include "render/smooth_surface.h"

#include <catch2/catch.hpp>

#include "render/weave_coordinates.h"
#include "support/draped_cloth.h"

using namespace drape;

TEST_CASE("smoothing a coarse ball brings it nearer to the sphere and never moves a simulated vertex",
          "[render]") {
    const Mesh mesh = ball(1, 8);
    const SmoothSurface surface(mesh, mesh.drawn, 2);
    const Points x = surface.positions(mesh.rest);
    CHECK(x.leftCols(mesh.vertices()) == mesh.rest);
    const double flat = 1 - surface.rest().colwise().norm().minCoeff();
    double worst = 0;
    for (int v = 0; v < x.cols(); ++v) worst = std::max(worst, std::abs(x.col(v).norm() - 1));
    CHECK(flat > 0.03);
    CHECK(worst < 0.15 * flat);
}

TEST_CASE("smoothing keeps a flat sheet flat and its border where it is", "[render]") {
    const Mesh mesh = make_pattern("alternating", {1, 1, 4, 4});
    const SmoothSurface surface(mesh, mesh.drawn, 2);
    CHECK((surface.positions(mesh.rest) - surface.rest()).norm() < 1e-12);
    CHECK(surface.faces().cols() == 16 * mesh.triangles());
    CHECK(surface.drawn().faces.cols() == surface.faces().cols());
}

TEST_CASE("the finer drawn mesh sits on the finer surface, triangle by triangle", "[render]") {
    Mesh mesh = make_pattern("one_way", {1, 1, 3, 3});
    mesh.drawn.uv.resize(2, 0);
    const SmoothSurface surface(mesh, with_weave_coordinates(mesh), 1);
    const DrawnMesh& drawn = surface.drawn();
    for (int f = 0; f < drawn.faces.cols(); ++f)
        for (int c = 0; c < 3; ++c)
            CHECK(drawn.vertex[static_cast<size_t>(drawn.faces(c, f))] == surface.faces()(c, f));
    REQUIRE(drawn.uv.cols() == static_cast<Eigen::Index>(drawn.vertex.size()));
}

TEST_CASE("the simulated edges keep their length when cut into pieces", "[render]") {
    const Mesh mesh = make_pattern("one_way", {1, 1, 2, 2});
    const auto length = [&](int levels) {
        const SmoothSurface surface(mesh, mesh.drawn, levels);
        double sum = 0;
        for (const auto& [a, b] : surface.simulated_edges())
            sum += (surface.rest().col(a) - surface.rest().col(b)).norm();
        return sum;
    };
    CHECK(length(2) == Approx(length(0)));
    CHECK(SmoothSurface(mesh, mesh.drawn, 2).simulated_edges().size() ==
          4 * SmoothSurface(mesh, mesh.drawn, 0).simulated_edges().size());
}

TEST_CASE("a value per simulated vertex spreads linearly", "[render]") {
    const Mesh mesh = make_pattern("alternating", {1, 1, 4, 4});
    const SmoothSurface surface(mesh, mesh.drawn, 2);
    const Eigen::VectorXf x = mesh.rest.row(0).cast<float>();
    CHECK((surface.spread(x) - Eigen::VectorXf(surface.rest().row(0).cast<float>())).norm() < 1e-5f);
}

TEST_CASE("a round border stays round, a square one keeps its corners", "[render]") {
    Mesh mesh = make_pattern("alternating", {1, 1, 6, 6});
    const bool round = GENERATE(true, false);
    for (int v = 0; round && v < mesh.vertices(); ++v) {  // the square blown up into a disc
        const double x = mesh.rest(0, v), z = mesh.rest(2, v), length = std::hypot(x, z);
        if (length > 0) mesh.rest.col(v) *= std::max(std::abs(x), std::abs(z)) / length;
    }
    const SmoothSurface surface(mesh, mesh.drawn, 2);
    const Points x = surface.positions(mesh.rest);
    const Eigen::VectorXf border = border_distance(surface.rest(), surface.faces());
    for (int v = 0; v < x.cols(); ++v) {
        if (border[v] > 1e-6f) continue;
        if (round) CHECK(x.col(v).norm() == Approx(0.5).epsilon(0.004));  // chords alone: 0.017
        if (!round) CHECK(x.col(v).cwiseAbs().maxCoeff() == Approx(0.5));
    }
}

TEST_CASE("layers that lie on each other are not smoothed through each other", "[render]") {
    // a sheet with sharp waves, and the same turned over and a little above where the waves are
    const Mesh mesh = make_pattern("one_way", {1, 1, 16, 16});
    const SmoothSurface surface(mesh, mesh.drawn, 2);
    constexpr double gap = 0.001;
    Points below = mesh.rest, above = mesh.rest;
    for (Eigen::Index v = 0; v < below.cols(); ++v) {
        below(1, v) = 0.05 * std::sin(18 * mesh.rest(0, v));
        above(1, v) = gap + std::max(below(1, v), 0.0);  // it lies on the crests
    }
    const auto lowest_gap = [&](const Eigen::VectorXd& room) {
        const Points under = surface.positions(below, room), over = surface.positions(above, room);
        return (over.row(1) - under.row(1)).minCoeff();
    };
    CHECK(lowest_gap({}) < 0);
    Eigen::VectorXd room = Eigen::VectorXd::Constant(mesh.vertices(), gap);
    CHECK(lowest_gap(room) > 0);
    CHECK(surface.positions(below, Eigen::VectorXd::Constant(mesh.vertices(), INFINITY)) ==
          surface.positions(below));
}
