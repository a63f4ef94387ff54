#include "simulate/strain.h"

#include <catch2/catch.hpp>

#include "support/cloths.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("cloth at rest, moved or turned has no strain", "[simulate]") {
    const Model model = model_of(square(4), bare_springs(100));
    const Pose pose{rotation_from_degrees({20, 50, -70}), {1, 2, 3}};
    Points x = model.cloths[0].mesh.rest;
    CHECK(largest_strain(model, x) == 0);
    for (Eigen::Index i = 0; i < x.cols(); ++i) x.col(i) = pose * x.col(i);
    CHECK(largest_strain(model, x) < 1e-14);
}

TEST_CASE("a vertex's strain is that of its edge strained most, with its sign", "[simulate]") {
    const Model model = model_of(equilateral_triangle(), bare_springs(100));
    const Cloth& cloth = model.cloths[0];
    const Points rest = cloth.mesh.rest;
    Points x = rest;
    x.col(1) = rest.col(2) + 0.8 * (rest.col(1) - rest.col(2));  // along edge 1-2, which shrinks by a fifth
    const double other = (x.col(1) - x.col(0)).norm() - 1;       // edge 0-1 shrinks by less
    REQUIRE(std::abs(other) < 0.2);
    const Eigen::VectorXf strain = vertex_strain(cloth, x);
    CHECK(strain[0] == Approx(other));
    CHECK(strain[1] == Approx(-0.2));
    CHECK(strain[2] == Approx(-0.2));
    CHECK(largest_strain(model, x) == Approx(0.2));
    CHECK(vertex_strain(cloth, 1.3 * rest).minCoeff() == Approx(0.3));
}

TEST_CASE("strain looks at every cloth, each in its own columns", "[simulate]") {
    Model model = model_of(square(2), bare_springs(100));
    add_cloth(model, make_cloth(square(3), bare_springs(100)));
    Points x(3, 9 + 16);
    x << model.cloths[0].mesh.rest, 1.1 * model.cloths[1].mesh.rest;
    CHECK(largest_strain(model, x) == Approx(0.1));
    CHECK(vertex_strain(model.cloths[0], x).cwiseAbs().maxCoeff() == 0);
    CHECK(vertex_strain(model.cloths[1], x).minCoeff() == Approx(0.1));
}
