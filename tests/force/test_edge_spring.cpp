#include "force/edge_spring.h"

#include <catch2/catch.hpp>

#include "support/cloths.h"
#include "support/forces.h"
#include "support/gradient.h"
#include "support/meshes.h"

using namespace drape;
using namespace drape::test;

namespace {

// c = 40 N/m, b = 3 N s/m
EdgeSprings one_spring(double rest_length, double damping = 0) {
    return EdgeSprings({{0, 1, rest_length, 40, damping}}, 0);
}

}  // namespace

TEST_CASE("one spring pulls and holds energy as its closed form says", "[force]") {
    const EdgeSprings spring = one_spring(0.5);
    const Vec3 along = Vec3(1, 2, -2) / 3;
    for (const double length : {0.01, 0.3, 0.5, 0.9}) {
        CAPTURE(length);
        const Points x = points_of({{1, 1, 1}, Vec3(1, 1, 1) + length * along}), f = force_at(spring, x);
        CHECK((f.col(0) - 40 * (length - 0.5) * along).norm() < 1e-12);
        CHECK((f.col(1) + 40 * (length - 0.5) * along).norm() < 1e-12);
        CHECK(spring.energy(x) == Approx(20 * (length - 0.5) * (length - 0.5)).margin(1e-28));
    }
}

TEST_CASE("a spring of no rest length is linear and passes through nothing smoothly", "[force]") {
    const EdgeSprings spring = one_spring(0);
    for (const double z : {-0.2, -1e-9, 0.0, 1e-9, 0.2}) {
        const Points x = points_of({{0, 0, 0}, {0, 0, z}});
        CHECK(force_at(spring, x)(2, 0) == Approx(40 * z));
        CHECK(spring.energy(x) == Approx(20 * z * z));
    }
}

TEST_CASE("a spring crushed to a point has no direction: it holds energy but pushes nowhere", "[force]") {
    const Points x = points_of({{1, 2, 3}, {1, 2, 3}}), v = points_of({{1, 0, 0}, {0, 1, 0}});
    CHECK(force_at(one_spring(0.5, 3), x, v).isZero(0));
    CHECK(one_spring(0.5).energy(x) == Approx(20 * 0.25));
}

TEST_CASE("a spring damps lengthening alone, and says how much heat that makes", "[force]") {
    const EdgeSprings spring = one_spring(0.5, 3);
    const Points x = points_of({{0, 0, 0}, {0.5, 0, 0}});
    Points f = Points::Zero(3, 2);
    const Power power = spring.add_all(x, points_of({{-1, 5, 0}, {1, -5, 2}}), 0, f);
    CHECK((f.col(0) - Vec3(6, 0, 0)).norm() < 1e-14);  // b (v1 - v0) along the spring
    CHECK((f.col(1) + Vec3(6, 0, 0)).norm() < 1e-14);
    CHECK(power.dissipated == Approx(12));
    CHECK(force_at(spring, x, points_of({{1, 2, 3}, {1, 2, 3}})).isZero(0));
    CHECK_FALSE(spring.is_conservative());
    CHECK(one_spring(0.5).is_conservative());
}

TEST_CASE("many springs sum like single ones, whatever their number", "[force]") {
    // more than one block of the vector loop, and every remainder
    for (int count = 1; count <= 70; ++count) {
        const Points x = random_points(count + 1, 1, 1), v = random_points(count + 1, 1, 2);
        std::vector<Spring> springs;
        Points expected = Points::Zero(3, count + 1);
        for (int i = 0; i < count; ++i) {
            springs.push_back({i, i + 1, 0.3, 10.0 + i, 0.1 * i});
            EdgeSprings({springs.back()}, 0).add_all(x, v, 0, expected);
        }
        CHECK((force_at(EdgeSprings(springs, 0), x, v) - expected).norm() < 1e-12);
    }
}

TEST_CASE("no pose of a spring is stiffer than its bound, and a stretched one is as stiff", "[force]") {
    for (const double length : {0.1, 0.5, 0.6, 5.0}) {
        const Points x = points_of({{0, 0, 0}, {0, length, 0}});
        const double ratio = largest_stiffness(one_spring(0.5), x) / largest_bound(one_spring(0.5), x);
        CHECK(ratio == Approx(1).epsilon(1e-6));
    }
}

TEST_CASE("a chain hangs in equilibrium where each link carries all below it", "[force]") {
    const int links = 30;
    const double mass = 0.02, stiffness = 300, rest_length = 0.05, g = 9.81;
    Cloth chain;
    chain.fabric = bare_springs(stiffness);
    chain.mesh.rest = Points::Zero(3, links + 1);
    chain.mass = Eigen::VectorXd::Constant(links + 1, mass);
    for (int i = 0; i < links; ++i) chain.network.edges.push_back({i, i + 1, rest_length, stiffness, 0});
    Points x = chain.mesh.rest;
    for (int i = 0; i < links; ++i) x(1, i + 1) = x(1, i) - rest_length - mass * g * (links - i) / stiffness;
    const Points f =
        force_at(*make_force("edge springs", chain), x) + force_at(*make_force("gravity", chain), x);
    CHECK(f.rightCols(links).norm() < 1e-12);  // measured: 1.2e-13
    CHECK(f(1, 0) == Approx(-mass * g * (links + 1)));
    // the exact sum is the continuum's rho g L^2 / (2 E) and half a link more
    const double length = links * rest_length, stretch = -x(1, links) - length;
    const double continuum = mass / rest_length * g * length * length / (2 * stiffness * rest_length);
    CHECK(stretch == Approx(continuum * (1 + 1.0 / links)));
}
