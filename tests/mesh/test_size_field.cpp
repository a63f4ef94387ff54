// Where an adaptive pattern is finer, and that it is.
#include "mesh/size_field.h"

#include <catch2/catch.hpp>

#include "mesh/pattern.h"
#include "mesh/topology.h"

using namespace drape;

using Vec2 = Eigen::Vector2d;

TEST_CASE("an adaptive pattern has the edges asked near points and lines and grows away from them",
          "[mesh]") {
    PatternSize size{1, 1, 20, 20};
    size.finer.points = {{0.25, 0.25}};
    size.finer.lines = {{Vec2(-0.5, -0.2), Vec2(0.1, -0.2)}};
    size.finer.finest = 0.01;
    size.finer.growth = 0.2;
    const Mesh mesh = make_pattern("adaptive", size);
    const SizeField wanted = finer_field(size.finer, 0.05, {-0.5, -0.5}, {0.5, 0.5});
    CHECK(wanted({0.25, 0.25}) == Approx(0.01));
    CHECK(wanted({0.25, 0.35}) == Approx(0.03));
    CHECK(wanted({0.4, -0.45}) == Approx(0.05));
    double worst = 1;
    for (const Edge& edge : build_topology(mesh.faces, mesh.vertices()).edges) {
        const Vec3 a = mesh.rest.col(edge.vertex[0]), b = mesh.rest.col(edge.vertex[1]);
        const double ratio = (a - b).norm() / wanted((Vec2(a.x(), a.z()) + Vec2(b.x(), b.z())) / 2);
        worst = std::max({worst, ratio, 1 / ratio});
    }
    CHECK(worst < 2);  // a Poisson disk leaves gaps of up to two of its radii
    CHECK(mesh.vertices() == Approx(vertices_asked(wanted, {-0.5, -0.5}, {0.5, 0.5})).epsilon(0.1));
}

TEST_CASE("an adaptive pattern is finer where a surface was curved", "[mesh]") {
    Finer finer;
    finer.finest = 0.005;
    for (int i = 0; i <= 50; ++i) finer.curved.push_back({{i / 50.0, 0.5}, 20});
    finer.curved.push_back({{0.5, 0.0}, 0});
    const SizeField wanted = finer_field(finer, 0.05, {0, 0}, {1, 1});
    // fifteen degrees along an edge, of a cylinder of 5 cm
    CHECK(wanted({0.3, 0.5}) == Approx(0.0131).epsilon(0.1));
    CHECK(wanted({0.3, 0.6}) == Approx(0.0131 + 0.25 * 0.1).epsilon(0.1));
    CHECK(wanted({0.3, 0.9}) == Approx(0.05));
}
