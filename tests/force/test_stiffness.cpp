// The matrices of implicit methods: every force in the table is held to finite differences of itself.
#include <catch2/catch.hpp>

#include "support/every_force.h"
#include "support/forces.h"
#include "support/matrices.h"
#include "support/pins.h"

using namespace drape;
using namespace drape::test;

namespace {

// A bent, moving cloth behind another one, two of its vertices pinned.
struct Bent {
    Model model = model_of(square(1), bare_springs(50));
    Points x, v;

    Bent(const Fabric& fabric, unsigned seed) {
        add_cloth(model, make_cloth(jittered_square(3, "alternating", 0.2), fabric));
        x = random_points(model.vertices(), 0.08, seed);
        v = random_points(model.vertices(), 1, seed + 1);
        for (const Cloth& cloth : model.cloths)
            x.middleCols(cloth.first, cloth.vertices()) += cloth.mesh.rest;
        hold(model, {1, 4, 11}, x);
    }
    BlockMatrix matrix(const Force& force) const {
        Couplings couplings;
        force.add_couplings(couplings);
        return BlockMatrix(model, couplings);
    }
};

// Of upper - lower, over the size of upper.
double least_eigenvalue(const Eigen::MatrixXd& upper, const Eigen::MatrixXd& lower) {
    return eigenvalues(upper - lower).minCoeff() / std::max(upper.norm(), 1e-12);
}

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return (a - b).norm() / std::max(b.norm(), 1e-3);
}

}  // namespace

TEST_CASE("every force's stiffness is the derivative of its force, on every fabric", "[force]") {
    unsigned seed = 20;
    for (const Fabric& fabric : every_fabric()) {
        const Bent bent(fabric, ++seed);
        for (const Case& c : every_force(bent.model.cloths[1])) {
            CAPTURE(c.name, int(fabric.stretch_model), int(fabric.altitude), int(fabric.bending_kind));
            BlockMatrix k = bent.matrix(*c.force);
            c.force->add_stiffness(bent.x, k);
            const Eigen::MatrixXd expected =
                minus_jacobian([&](In y) { return force_at(*c.force, y); }, bent.x, 1e-5, bent.model);
            CHECK(difference(dense(k, bent.model.vertices()), expected) < 1e-8);
        }
    }
}

TEST_CASE("every force's damping is the derivative by the velocities, and the wind's is semidefinite",
          "[force]") {
    unsigned seed = 60;
    for (const Fabric& fabric : every_fabric()) {
        const Bent bent(fabric, ++seed);
        for (const Case& c : every_force(bent.model.cloths[1])) {
            CAPTURE(c.name, int(fabric.stretch_model), int(fabric.altitude), int(fabric.bending_kind));
            BlockMatrix b = bent.matrix(*c.force);
            c.force->add_damping(bent.x, bent.v, 0.3, b);
            const Eigen::MatrixXd found = dense(b, bent.model.vertices());
            const double least = eigenvalues(found).minCoeff();
            CHECK(least >= -1e-12 * found.norm());
            const Eigen::MatrixXd exact = minus_jacobian(
                [&](In w) { return force_at(*c.force, bent.x, w, 0.3); }, bent.v, 1e-3, bent.model);
            CHECK(difference(found, (exact + exact.transpose()) / 2) < (c.name == "wind" ? 0.3 : 1e-9));
        }
    }
}

TEST_CASE("no sheet, however crushed, has a stiffness that is not a number", "[force]") {
    for (const Fabric& fabric : every_fabric()) {
        Bent bent(fabric, 3);
        Points line = bent.x, edge = bent.x, point = bent.x;
        line.row(0).setZero();
        line.row(1).setZero();
        edge.col(9) = edge.col(10);
        point.setConstant(0.3);
        for (const Points& x : {line, edge, point}) {
            for (const Case& c : every_force(bent.model.cloths[1])) {
                CAPTURE(c.name, int(fabric.altitude), int(fabric.bending_kind));
                BlockMatrix k = bent.matrix(*c.force);
                k.weigh(1, true);
                c.force->add_stiffness(x, k);
                c.force->add_damping(x, bent.v, 0.3, k);
                CHECK(k.lower().coeffs().allFinite());
            }
        }
    }
}

TEST_CASE("near rest no force is stiffer than its majorant or more damped, edge springs and plates nowhere",
          "[force]") {
    unsigned seed = 80;
    for (const Fabric& fabric : every_fabric()) {
        const Model model = model_of(jittered_square(3, "alternating", 0.2), fabric);
        const Points& rest = model.cloths[0].mesh.rest;
        for (const Case& c : every_force(model.cloths[0])) {
            Majorant stiffness, damping;
            c.force->add_stiffness_majorant(stiffness);
            c.force->add_damping_majorant(damping);
            const Eigen::MatrixXd most_k = dense(stiffness, rest.cols()),
                                  most_b = dense(damping, rest.cols());
            Couplings couplings;
            c.force->add_couplings(couplings);
            const bool anywhere = c.name == "edge springs" ||
                                  (c.name == "bending" && fabric.bending_kind != BendingKind::hinge);
            for (const double amount : {0.0, 0.01, 0.02, anywhere ? 1.0 : 0.03}) {
                const Points x = rest + random_points(rest.cols(), amount, ++seed);
                BlockMatrix k(model, couplings), b(model, couplings);
                c.force->add_stiffness(x, k);
                c.force->add_damping(x, random_points(rest.cols(), 1, seed), 0.3, b);
                CAPTURE(c.name, int(fabric.altitude), int(fabric.bending_kind), amount);
                CHECK(least_eigenvalue(most_k, dense(k, rest.cols())) > -1e-12);
                CHECK(least_eigenvalue(most_b, dense(b, rest.cols())) > -1e-12);
            }
        }
    }
}
