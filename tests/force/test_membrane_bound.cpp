#include <catch2/catch.hpp>

#include "support/forces.h"
#include "support/matrices.h"
#include "support/membranes.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("no pose of a triangle is stiffer than the membrane's bound", "[force]") {
    for (const MembraneKind kind : membrane_kinds) {
        double closest = 0, at_rest = 0;
        for (unsigned seed = 1; seed <= 1000; ++seed) {
            Mesh mesh = equilateral_triangle();
            mesh.rest += random_points(3, 0.2, 1000 + seed);
            const double nu = 0.5 - 0.001 * seed;
            const Membrane membrane(make_cloth(mesh, membrane_fabric(kind, 1, nu)));
            const double size = 0.02 * (seed % 50);
            const Points x = mesh.rest + random_points(3, size, seed);
            const double share = largest_stiffness(membrane, x) / largest_bound(membrane, x);
            closest = std::max(closest, share);
            if (size == 0) at_rest = at_rest == 0 ? share : std::min(at_rest, share);
        }
        CAPTURE(int(kind), closest, at_rest);
        CHECK(closest < 1 + 1e-8);
        CHECK(at_rest > 0.5);  // else the bound would cost steps for nothing
    }
}

TEST_CASE("a membrane's damping is within its bound, in every state", "[force]") {
    for (const MembraneKind kind : membrane_kinds) {
        Fabric fabric = membrane_fabric(kind, 50, 0.4);
        fabric.damping = 0.2;
        const Model model = model_of(jittered_square(3, "alternating", 0.2), fabric);
        const Membrane membrane(model.cloths[0]);
        Couplings couplings;
        membrane.add_couplings(couplings);
        for (const NamedPose& pose : membrane_poses(model.cloths[0].mesh)) {
            BlockMatrix b(model, couplings);
            membrane.add_damping(pose.x, pose.x, 0, b);
            StepBound bound(model.vertices());
            membrane.add_bound(pose.x, bound);
            const double largest = eigenvalues(dense(b, model.vertices())).maxCoeff();
            CAPTURE(int(kind), pose.name);
            CHECK(bound.damping.maxCoeff() >= largest);
            CHECK(bound.damping.maxCoeff() < 3 * largest);
        }
    }
}

TEST_CASE("a membrane's constant bound holds to a stretch of 1.29 and half the area", "[force]") {
    for (const MembraneKind kind : membrane_kinds) {
        for (const double nu : {-0.5, 0.0, 0.3, 0.5}) {
            Fabric fabric = membrane_fabric(kind, 50, nu);
            fabric.damping = 0.2;
            const Model model = model_of(jittered_square(3, "alternating", 0.2), fabric);
            const Points& rest = model.cloths[0].mesh.rest;
            const Membrane membrane(model.cloths[0]);
            Majorant stiffness, damping;
            membrane.add_stiffness_majorant(stiffness);
            membrane.add_damping_majorant(damping);
            Couplings couplings;
            membrane.add_couplings(couplings);
            const Eigen::MatrixXd most_k = dense(stiffness, rest.cols()),
                                  most_b = dense(damping, rest.cols());
            for (const auto& [s1, s2] : {std::pair{1.29, 1.29}, {1.29, 1.0}, {1.29, 0.39}, {0.71, 0.71}}) {
                const Points x = Vec3(s1, 1, s2).asDiagonal() * rest;
                BlockMatrix k(model, couplings), b(model, couplings);
                membrane.add_stiffness(x, k);
                membrane.add_damping(x, x, 0, b);
                CAPTURE(int(kind), nu, s1, s2);
                CHECK(eigenvalues(most_k - dense(k, rest.cols())).minCoeff() > -1e-12 * most_k.norm());
                CHECK(eigenvalues(most_b - dense(b, rest.cols())).minCoeff() > -1e-12 * most_b.norm());
            }
        }
    }
}
