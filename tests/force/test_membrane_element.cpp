#include "force/membrane_element.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/altitudes.h"
#include "support/matrices.h"
#include "support/membranes.h"

using namespace drape;
using namespace drape::test;

namespace {

constexpr double modulus = 40, poisson = 0.3;  // [N/m], [-]

struct Triangle {
    Cloth cloth;
    MembraneElement element;
    MembraneModuli moduli;

    explicit Triangle(MembraneKind kind, double nu = poisson)
        : cloth(make_cloth(scalene_triangle(), membrane_fabric(kind, modulus, nu))),
          element(membrane_element(cloth, 0)),
          moduli(moduli_of(cloth.fabric)) {}

    // Energy per area under the stretches along two directions at right angles in the rest triangle's plane,
    // the first at `angle` from its first edge, after a shear.
    double density(double s1, double s2, double angle = 0, double shear = 0) const {
        const Points& rest = cloth.mesh.rest;
        const Vec3 normal =
            Vec3(rest.col(1) - rest.col(0)).cross(Vec3(rest.col(2) - rest.col(0))).normalized();
        const Vec3 along = Eigen::AngleAxisd(angle, normal) * (rest.col(1) - rest.col(0)).normalized();
        const Vec3 across = normal.cross(along);
        const Mat3 f = s1 * along * along.transpose() + s2 * across * across.transpose() +
                       shear * along * across.transpose() + normal * normal.transpose();
        return energy(f * rest) / element.area;
    }
    double energy(In x) const { return response(x).energy; }
    MembraneResponse response(In x) const {
        const MembranePose pose = membrane_pose(element, x);
        return cloth.fabric.membrane == MembraneKind::stvk ? stvk_response(element, pose)
                                                           : neo_hookean_response(element, pose, moduli);
    }
};

}  // namespace

TEST_CASE("St. Venant-Kirchhoff's energy is that of Green's strain in plane stress", "[force]") {
    const Triangle t(MembraneKind::stvk);
    for (const double s1 : {0.2, 0.9, 1.0, 1.4})
        for (const double s2 : {0.5, 1.0, 2.0}) {
            const double e1 = (s1 * s1 - 1) / 2, e2 = (s2 * s2 - 1) / 2;
            const double expected =
                modulus / (2 * (1 - poisson * poisson)) * (e1 * e1 + e2 * e2 + 2 * poisson * e1 * e2);
            CAPTURE(s1, s2);
            CHECK(t.density(s1, s2, 0.4) == Approx(expected).epsilon(1e-11).margin(1e-13));
        }
}

TEST_CASE("neo-Hookean's energy is mu of shape and kappa of area", "[force]") {
    const Triangle t(MembraneKind::neo_hookean);
    const double mu = modulus / (2 * (1 + poisson)), kappa = modulus / (2 * (1 - poisson));
    for (const double s1 : {0.0, 0.2, 0.9, 1.0, 1.4})
        for (const double s2 : {0.5, 1.0, 2.0}) {
            const double expected =
                mu / 2 * (s1 - s2) * (s1 - s2) + kappa / 2 * (s1 * s2 - 1) * (s1 * s2 - 1);
            CAPTURE(s1, s2);
            CHECK(t.density(s1, s2, 0.4) == Approx(expected).epsilon(1e-11).margin(1e-13));
        }
}

TEST_CASE("small strains of a membrane are linear elasticity in plane stress, in every direction",
          "[force]") {
    for (const MembraneKind kind : membrane_kinds) {
        for (const double nu : {-0.4, 0.0, 0.3, 0.5}) {
            const Triangle t(kind, nu);
            constexpr double e = 1e-4;
            for (const double angle : {0.0, 0.3, 1.0, 2.0}) {
                CAPTURE(int(kind), nu, angle);
                // a pull along one direction meets Y where the other is free to contract by nu
                const auto bent = [&](double lateral) { return t.density(1 + e, 1 + lateral, angle); };
                const double least = -nu * e;
                CHECK(bent(least) == Approx(modulus / 2 * e * e).epsilon(1e-3));
                CHECK(bent(least) < bent(least + 0.05 * e));
                CHECK(bent(least) < bent(least - 0.05 * e));
                // held across it meets Y / (1 - nu^2); shear meets Y / (2 (1 + nu))
                CHECK(bent(0) == Approx(modulus / (1 - nu * nu) / 2 * e * e).epsilon(1e-3));
                CHECK(t.density(1, 1, angle, e) == Approx(modulus / (4 * (1 + nu)) * e * e).epsilon(1e-3));
            }
        }
    }
}

TEST_CASE("compressed, St. Venant-Kirchhoff gives way below 0.577 of its length, neo-Hookean never",
          "[force]") {
    const auto push = [](const Triangle& t, double s) {
        return -(t.density(s + 1e-5, 1) - t.density(s - 1e-5, 1)) / 2e-5;
    };
    const Triangle stvk(MembraneKind::stvk), neo_hookean(MembraneKind::neo_hookean);
    CHECK(push(stvk, 0.577) > push(stvk, 0.65));
    CHECK(push(stvk, 0.577) > push(stvk, 0.5));
    CHECK(push(stvk, 0.01) < 0.03 * push(stvk, 0.577));
    double last = 0;
    for (const double s : {0.9, 0.6, 0.3, 0.1, 0.01}) {
        CHECK(push(neo_hookean, s) > last);
        last = push(neo_hookean, s);
    }
    // mu + kappa where the triangle has no area left
    CHECK(push(neo_hookean, 1e-4) == Approx(neo_hookean.moduli.mu + neo_hookean.moduli.kappa).epsilon(1e-3));
}

TEST_CASE("tensions and their change are derivatives by the squared edges", "[force]") {
    for (const MembraneKind kind : membrane_kinds) {
        const Triangle t(kind);
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const Points x = t.cloth.mesh.rest + random_points(3, 0.3, seed);
            const MembraneResponse at = t.response(x);
            // along a move of the corners: dE = 1/2 sum t_k dQ_k, dt = sum change dQ
            const Points way = random_points(3, 1, 100 + seed);
            constexpr double h = 1e-5;
            const Points ahead = x + h * way, behind = x - h * way;
            const Eigen::Vector3d rate =
                (membrane_pose(t.element, ahead).squared - membrane_pose(t.element, behind).squared) /
                (2 * h);
            const double slope = (t.energy(ahead) - t.energy(behind)) / (2 * h);
            CAPTURE(int(kind), seed);
            CHECK(slope == Approx(at.tension.dot(rate) / 2).epsilon(1e-6).margin(1e-6));
            const Eigen::Vector3d change = (t.response(ahead).tension - t.response(behind).tension) / (2 * h);
            CHECK((change - at.change * rate).norm() < 1e-5 * (1 + change.norm()));
        }
    }
}

TEST_CASE("a membrane's damping ratio of one is critical for the triangle's fastest motion", "[force]") {
    Fabric fabric = membrane_fabric(MembraneKind::stvk, modulus);
    fabric.damping = 1;
    const Cloth cloth = make_cloth(scalene_triangle(), fabric);
    const MembraneElement element = membrane_element(cloth, 0);
    // all modes of the triangle alone: C and K share them, so gamma = tau omega^2 = 2 omega
    Membrane membrane(cloth);
    Model model;
    add_cloth(model, cloth);
    Couplings couplings;
    membrane.add_couplings(couplings);
    BlockMatrix k(model, couplings), b(model, couplings);
    membrane.add_stiffness(cloth.mesh.rest, k);
    membrane.add_damping(cloth.mesh.rest, Points::Zero(3, 3), 0, b);
    const Eigen::MatrixXd stiffness = Eigen::MatrixXd(k.lower()).selfadjointView<Eigen::Lower>();
    const Eigen::MatrixXd damping = Eigen::MatrixXd(b.lower()).selfadjointView<Eigen::Lower>();
    CHECK((damping - element.relaxation * stiffness).norm() < 1e-12 * damping.norm());
    // a third of the mass sits at each corner
    const double omega = std::sqrt(eigenvalues(stiffness / cloth.mass[0]).maxCoeff());
    CHECK(element.relaxation * omega == Approx(2));
}
