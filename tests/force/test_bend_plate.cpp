#include "force/bend_plate.h"

#include <catch2/catch.hpp>

#include "support/forces.h"
#include "support/matrices.h"
#include "support/sheets.h"

using namespace drape;
using namespace drape::test;

namespace {

// K for one coordinate, column by column
Eigen::MatrixXd stiffness_matrix(const BendPlate& plate, int vertices) {
    Eigen::MatrixXd k(vertices, vertices);
    for (int i = 0; i < vertices; ++i) {
        Points x = Points::Zero(3, vertices);
        x(1, i) = 1;
        k.col(i) = -force_at(plate, x).row(1).transpose();
    }
    return k;
}

double relaxation_time(const Fabric& fabric, int divisions) {
    const Cloth cloth = make_cloth(square(divisions), fabric);
    const BendPlate plate(cloth);
    const Points v = random_points(cloth.vertices(), 1, 3);
    Points f = Points::Zero(3, cloth.vertices());
    // dissipated is tau v' K v, and v' K v twice the energy of a pose v
    return plate.add_all(cloth.mesh.rest, v, 0, f).dissipated / (2 * plate.energy(v));
}

}  // namespace

TEST_CASE("the plate's energy is exact for every quadratic surface on every mesh", "[force]") {
    const double a = 0.7, b = -0.4, c = 1.1;
    for (const Sheet& sheet : every_sheet(8)) {
        CAPTURE(sheet.name);
        for (const double poisson : {0.0, 0.3, 0.5}) {
            Fabric fabric = bending_fabric(BendingKind::plate, 2);
            fabric.poisson = poisson;
            const Cloth cloth = make_cloth(sheet.mesh, fabric);
            const BendPlate plate(cloth);
            CHECK(plate.incomplete_triangles() == 0);
            const Points x = lifted(sheet.mesh, [&](double u, double v) {
                return 3 + 0.2 * u - v + a * u * u / 2 + b * u * v + c * v * v / 2;
            });
            const double density = (a + c) * (a + c) - 2 * (1 - poisson) * (a * c - b * b);
            // measured: within 1e-11
            CHECK(plate.energy(x) == Approx(0.5 * 2 * rest_area(cloth) * density).epsilon(1e-10));
        }
    }
}

TEST_CASE("moving and tilting are the only ways to deform a plate for nothing", "[force]") {
    for (const Sheet& sheet : every_sheet(5)) {
        CAPTURE(sheet.name);
        const Cloth cloth = make_cloth(sheet.mesh, bending_fabric(BendingKind::plate));
        const Eigen::MatrixXd k = stiffness_matrix(BendPlate(cloth), cloth.vertices());
        CHECK((k - k.transpose()).norm() < 1e-13 * k.norm());
        const Eigen::VectorXd values = eigenvalues(k);
        CHECK(values.head<3>().cwiseAbs().maxCoeff() < 1e-14 * values.maxCoeff());  // measured: 1.2e-16
        // measured: 1.3e-3 to 5e-3; crosses, jittered, 3.7e-4
        CHECK(values[3] > (sheet.name == "crossed, jittered" ? 3e-4 : 5e-4) * values.maxCoeff());
        Eigen::MatrixXd rigid(cloth.vertices(), 3);
        rigid << Eigen::VectorXd::Ones(cloth.vertices()), sheet.mesh.rest.row(0).transpose(),
            sheet.mesh.rest.row(2).transpose();
        CHECK((k * rigid).norm() < 1e-12 * k.norm());
    }
}

TEST_CASE("a plate rolled to a cylinder has the rigidity asked, at every angle on every mesh", "[force]") {
    const double radius = 5;
    for (const Sheet& sheet : every_sheet(16)) {
        const Cloth cloth = make_cloth(sheet.mesh, bending_fabric(BendingKind::plate));
        const BendPlate plate(cloth);
        for (const double angle : {0.0, 22.5, 45.0, 90.0, 135.0}) {
            CAPTURE(sheet.name, angle);
            const double exact = 0.5 * rest_area(cloth) / (radius * radius);
            // measured: within 3e-4, the cylinder not being quadratic
            CHECK(plate.energy(rolled(sheet.mesh, radius, angle)) / exact == Approx(1).margin(1e-3));
        }
    }
}

TEST_CASE(
    "a plate too narrow to see every curvature feels no moving or tilting, and bends lengthwise as asked",
    "[force]") {
    for (const PatternKind& kind : pattern_kinds()) {
        if (!kind.on_grid) continue;  // more vertices across than a side has
        for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 2}, {1, 9}, {9, 1}}) {
            CAPTURE(kind.name, columns, rows);
            const Cloth cloth =
                make_cloth(make_pattern(kind.name, {0.1 * columns, 0.1 * rows, columns, rows}),
                           bending_fabric(BendingKind::plate));
            const BendPlate plate(cloth);
            CHECK(plate.incomplete_triangles() == cloth.mesh.triangles());
            const Points tilted = lifted(cloth.mesh, [](double u, double v) { return 3 + 0.5 * u - v; });
            CHECK(force_at(plate, tilted).norm() < 1e-11);  // measured: 3e-13
            const Points lengthwise = lifted(
                cloth.mesh, [&](double u, double v) { return columns > rows ? u * u / 2 : v * v / 2; });
            if (columns != rows) CHECK(plate.energy(lengthwise) == Approx(0.5 * rest_area(cloth)));
        }
    }
}

TEST_CASE("a lone triangle cannot bend and a plate leaves it alone", "[force]") {
    const BendPlate plate(make_cloth(equilateral_triangle(), bending_fabric(BendingKind::plate)));
    CHECK(plate.incomplete_triangles() == 1);
    CHECK(force_at(plate, random_points(3, 1, 1)).norm() < 1e-13);
}

TEST_CASE("bending waves of the fabric's own length are damped by the fabric's ratio, if the step allows",
          "[force]") {
    Fabric fabric = bending_fabric(BendingKind::plate, 1e-4);
    fabric.density = 0.15;
    fabric.stretch = 1000;
    fabric.damping = 0.05;
    // omega = sqrt(B / rho) / l_b^2 with l_b^3 = B / (rho g); a mode of -K (x + tau v) has the ratio tau
    // omega / 2
    const double length = std::cbrt(1e-4 / (0.15 * 9.80665));
    const double omega = std::sqrt(1e-4 / 0.15) / (length * length);
    CHECK(relaxation_time(fabric, 6) * omega / 2 == Approx(0.05).epsilon(1e-9));
    fabric.bending = 0.1;
    const double capped = relaxation_time(fabric, 24);
    fabric.damping = 0.1;
    CHECK(relaxation_time(fabric, 24) == Approx(capped));
    fabric.damping = 0;
    CHECK(BendPlate(make_cloth(square(4), fabric)).is_conservative());
}
