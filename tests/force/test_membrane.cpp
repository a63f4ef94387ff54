#include "force/membrane.h"

#include <catch2/catch.hpp>

#include "force/altitude_spring.h"
#include "support/altitudes.h"
#include "support/forces.h"
#include "support/matrices.h"
#include "support/membranes.h"
#include "support/sheets.h"

using namespace drape;
using namespace drape::test;

namespace {

Cloth sheet(MembraneKind kind, double damping = 0) {
    Fabric fabric = membrane_fabric(kind, 50, 0.25);
    fabric.damping = damping;
    return make_cloth(jittered_square(3, "alternating", 0.2), fabric);
}

// The largest force at a vertex inside the sheet, over the largest at its border.
double largest_inside(const Force& force, const Mesh& mesh, In x) {
    const Points f = force_at(force, x);
    double inside = 0, border = 0;
    for (int v = 0; v < mesh.vertices(); ++v) {
        const bool inner = std::max(std::abs(mesh.rest(0, v)), std::abs(mesh.rest(2, v))) < 0.5 - 1e-9;
        (inner ? inside : border) = std::max(inner ? inside : border, f.col(v).norm());
    }
    return inside / border;
}

}  // namespace

TEST_CASE("a membrane's force is minus its energy's gradient, its stiffness the force's, in every state",
          "[force]") {
    for (const MembraneKind kind : membrane_kinds) {
        const Cloth cloth = sheet(kind);
        const Membrane membrane(cloth);
        const Model model = model_of(cloth.mesh, cloth.fabric);
        for (const NamedPose& pose : membrane_poses(cloth.mesh)) {
            CAPTURE(int(kind), pose.name);
            const Points f = force_at(membrane, pose.x);
            const Points expected = minus_gradient([&](In y) { return membrane.energy(y); }, pose.x, 1e-5);
            CHECK((f - expected).norm() < 1e-8 * expected.norm());
            Couplings couplings;
            membrane.add_couplings(couplings);
            BlockMatrix k(model, couplings);
            membrane.add_stiffness(pose.x, k);
            const Eigen::MatrixXd exact =
                minus_jacobian([&](In y) { return force_at(membrane, y); }, pose.x, 1e-5, model);
            CHECK((dense(k, model.vertices()) - exact).norm() < 1e-8 * exact.norm());
            // as implicit stages ask for it: nothing below zero, and nothing but negative parts left out
            k.set_zero();
            k.weigh(1, true);
            membrane.add_stiffness(pose.x, k);
            const Eigen::MatrixXd projected = dense(k, model.vertices());
            CHECK(eigenvalues(projected).minCoeff() > -1e-10 * projected.norm());
            CHECK(eigenvalues(projected - exact).minCoeff() > -1e-7 * projected.norm());
        }
    }
}

TEST_CASE("a membrane passes the patch test: an even strain leaves no force inside an irregular sheet",
          "[force]") {
    Mat3 strain = rotation_from_degrees({25, 10, -40});
    strain *= Mat3{{1.3, 0, 0.2}, {0, 1, 0}, {-0.1, 0, 0.8}};
    for (const Mesh& mesh : {jittered_square(6, "alternating", 0.25), square(8, "pseudo_random")}) {
        const Points x = (strain * mesh.rest).colwise() + Vec3(3, 1, -2);
        for (const MembraneKind kind : membrane_kinds) {
            const Membrane membrane(make_cloth(mesh, membrane_fabric(kind, 50)));
            CAPTURE(int(kind));
            CHECK(largest_inside(membrane, mesh, x) < 2e-13);  // measured 4.5e-14
        }
        // springs of the same modulus do not
        const Cloth springs = make_cloth(mesh, membrane_fabric(MembraneKind::none, 50));
        CHECK(largest_inside(*make_force("edge springs", springs), mesh, x) > 0.05);
    }
}

TEST_CASE("a membrane moved and turned as a whole has no energy, no force and no damping", "[force]") {
    const Mat3 turn = rotation_from_degrees({20, 130, -70});
    for (const MembraneKind kind : membrane_kinds) {
        const Cloth cloth = sheet(kind, 0.3);
        const Membrane membrane(cloth);
        const Points x = (turn * cloth.mesh.rest).colwise() + Vec3(3, -2, 5);
        CAPTURE(int(kind));
        CHECK(std::abs(membrane.energy(x)) < 1e-13);  // of 50 N/m on a square metre
        CHECK(force_at(membrane, x).norm() < 1e-12);
        const Vec3 spin(1, 2, -3);
        Points v = x;
        for (Eigen::Index i = 0; i < x.cols(); ++i) v.col(i) = spin.cross(Vec3(x.col(i))) + Vec3(4, 0, 1);
        for (const NamedPose& pose : membrane_poses(cloth.mesh)) {
            Points turning = pose.x;
            for (Eigen::Index i = 0; i < x.cols(); ++i) turning.col(i) = spin.cross(Vec3(pose.x.col(i)));
            CHECK((force_at(membrane, pose.x, turning) - force_at(membrane, pose.x)).norm() < 1e-11);
        }
        CHECK(force_at(membrane, x, v).norm() < 1e-11);
    }
    // at its very rest shape St. Venant-Kirchhoff is at ease to the last bit
    const Cloth cloth = sheet(MembraneKind::stvk);
    CHECK(force_at(Membrane(cloth), cloth.mesh.rest).isZero(0));
}

TEST_CASE("a membrane pushes nothing as a whole and turns nothing, damped and in every state", "[force]") {
    for (const MembraneKind kind : membrane_kinds) {
        const Cloth cloth = sheet(kind, 0.3);
        const Membrane membrane(cloth);
        for (const NamedPose& pose : membrane_poses(cloth.mesh)) {
            CAPTURE(int(kind), pose.name);
            const Points f = force_at(membrane, pose.x, random_points(pose.x.cols(), 1, 3));
            CHECK(net_force(f).norm() < 1e-13 * f.norm());
            CHECK(net_torque(pose.x, f).norm() < 1e-13 * f.norm());
        }
    }
}

TEST_CASE("a membrane is as stiff as asked on every mesh and in every direction", "[force]") {
    constexpr double e = 1e-4, nu = 0.25;
    for (const Sheet& sheet : every_sheet(5)) {
        for (const MembraneKind kind : membrane_kinds) {
            const Cloth cloth = make_cloth(sheet.mesh, membrane_fabric(kind, 50, nu));
            CHECK(cloth.network.modulus.least == 50);
            CHECK(cloth.network.modulus.most == 50);
            const Membrane membrane(cloth);
            for (const double angle : {0.0, 0.5, 1.2, 2.5}) {
                const Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
                const Mat3 strain = turn * Vec3(1 + e, 1, 1 - nu * e).asDiagonal() * turn.transpose();
                CAPTURE(sheet.name, int(kind), angle);
                CHECK(membrane.energy(strain * cloth.mesh.rest) ==
                      Approx(50 * e * e / 2 * rest_area(cloth)).epsilon(1e-3));
            }
        }
    }
}

TEST_CASE("a collapsed triangle of a membrane has finite forces, and neo-Hookean's push out of it",
          "[force]") {
    for (const MembraneKind kind : membrane_kinds) {
        const Cloth cloth = make_cloth(scalene_triangle(), membrane_fabric(kind, 50));
        const Membrane membrane(cloth);
        for (const Points& x : collapsed_triangles()) {
            CHECK(force_at(membrane, x).allFinite());
            CHECK(std::isfinite(membrane.energy(x)));
            CHECK(std::isfinite(largest_bound(membrane, x)));
        }
        // all but flat: the far corner is pushed away from its edge
        Points flat = cloth.mesh.rest;
        const auto altitude = altitude_of(flat.col(0), flat.col(2), flat.col(1));
        REQUIRE(altitude);
        flat.col(1) -= (1 - 1e-6) * altitude->height * altitude->up;
        const double push = force_at(membrane, flat).col(1).dot(altitude->up);
        CAPTURE(int(kind), push);
        if (kind == MembraneKind::neo_hookean) CHECK(push > 5);
        if (kind == MembraneKind::stvk) CHECK(std::abs(push) < 1e-3);
    }
}
