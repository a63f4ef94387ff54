#include "cloth/network.h"

#include <catch2/catch.hpp>

#include <Eigen/Dense>

#include "support/forces.h"
#include "support/meshes.h"
#include "support/sheets.h"

using namespace drape;
using namespace drape::test;

namespace {

Fabric fabric_of(StretchModel model, AltitudeMode altitude = AltitudeMode::none, double ratio = 1) {
    Fabric fabric = bare_springs(80);
    fabric.stretch_model = model;
    fabric.altitude = altitude;
    fabric.altitude_ratio = ratio;
    return fabric;
}

Network network_of(const Mesh& mesh, const Fabric& fabric) {
    return make_cloth(mesh, fabric).network;
}

// A uniaxial pull on the sheet, by the energy of its forces alone: the energy under strains (exx, ezz, gxz)
// is 1/2 S e' C e, and what pulls along the angle meets 1 / (s' C^-1 s), s = (cos^2, sin^2, cos sin).
class Pull {
public:
    explicit Pull(const Cloth& cloth) {
        const auto edges = make_force("edge springs", cloth),
                   altitudes = make_force("altitude springs", cloth);
        const auto energy = [&](const Eigen::Vector3d& strain) {
            Mat3 stretch = Mat3::Identity();
            stretch(0, 0) += strain[0];
            stretch(2, 2) += strain[1];
            stretch(0, 2) = stretch(2, 0) = strain[2] / 2;
            const Points x = stretch * cloth.mesh.rest;
            return edges->energy(x) + (altitudes ? altitudes->energy(x) : 0);
        };
        const double tiny = 1e-4;
        Mat3 c;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                const Eigen::Vector3d p = tiny * Eigen::Vector3d::Unit(i),
                                      q = tiny * Eigen::Vector3d::Unit(j);
                c(i, j) =
                    (energy(p + q) - energy(p - q) - energy(q - p) + energy(-p - q)) / (4 * tiny * tiny);
            }
        }
        compliance_ = (c / cloth.area.sum()).inverse();
    }
    double along(double angle_deg) const {
        const double c = std::cos(angle_deg * std::numbers::pi / 180),
                     s = std::sin(angle_deg * std::numbers::pi / 180);
        const Eigen::Vector3d pull(c * c, s * s, c * s);
        return 1 / pull.dot(compliance_ * pull);
    }
    double mean() const {
        double sum = 0;
        for (int i = 0; i < 180; ++i) sum += along(i);
        return sum / 180;
    }

private:
    Mat3 compliance_;
};

}  // namespace

TEST_CASE("a force per strain gives every spring the same k: c = k / l0", "[cloth]") {
    for (const Spring& spring : network_of(two_triangles(), fabric_of(StretchModel::force_per_strain)).edges)
        CHECK(spring.stiffness * spring.rest_length == Approx(80));
}

TEST_CASE("a spring constant gives every spring the same c", "[cloth]") {
    for (const Spring& spring : network_of(two_triangles(), fabric_of(StretchModel::spring_constant)).edges)
        CHECK(spring.stiffness == 80);
}

TEST_CASE("a membrane spreads its modulus over edges by the area beside them", "[cloth]") {
    const Network network = network_of(two_triangles(), fabric_of(StretchModel::membrane));
    for (const Spring& spring : network.edges) {
        const bool diagonal = spring.a == 0 && spring.b == 2;
        // sum(A) / l0^2: 1 / 2 on the diagonal, 1/2 / 1 on the border
        CHECK(spring.rest_length == Approx(diagonal ? std::sqrt(2.0) : 1));
        CHECK(spring.stiffness == Approx(network.calibration * 80 * 0.5));
    }
}

TEST_CASE("altitudes have the edges' stiffness times the ratio, in the edges' own coin", "[cloth]") {
    const Mesh mesh = plain_mesh(points_of({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}), faces_of({{0, 1, 2}}));
    const Eigen::Vector3d heights(2.4, 3, 4);
    const auto weights = [&](StretchModel model) {
        const TriangleAltitudes altitudes =
            network_of(mesh, fabric_of(model, AltitudeMode::all, 0.5)).altitudes.at(0);
        CHECK((altitudes.rest_height - heights).norm() < 1e-14);
        return altitudes;
    };
    const auto per_strain = weights(StretchModel::force_per_strain);  // W = k h0
    CHECK((per_strain.weight - 40 * heights).norm() < 1e-12);
    CHECK(per_strain.common_weight == Approx(40 * heights.mean()));
    const auto constant = weights(StretchModel::spring_constant);  // W = c h0^2
    CHECK((constant.weight - 40 * heights.cwiseAbs2()).norm() < 1e-12);
    const auto membrane = weights(StretchModel::membrane);  // W ~ K A
    CHECK((membrane.weight - Eigen::Vector3d::Constant(membrane.common_weight)).norm() < 1e-12);
}

TEST_CASE("a membrane pulled from every side has the mean modulus asked, with altitudes and without",
          "[cloth]") {
    for (const AltitudeMode mode :
         {AltitudeMode::none, AltitudeMode::compressed, AltitudeMode::all, AltitudeMode::blend}) {
        for (const Sheet& sheet : every_sheet(8)) {
            CAPTURE(int(mode), sheet.name);
            const Cloth cloth = make_cloth(sheet.mesh, fabric_of(StretchModel::membrane, mode, 0.7));
            const DirectionalModulus& modulus = cloth.network.modulus;
            const Pull pull(cloth);
            CHECK(pull.mean() == Approx(80).epsilon(1e-6));  // measured: 4e-8
            CHECK(modulus.mean == Approx(80));
            // the angle counts from the x axis, towards z on the other hand: one of the two
            CHECK(std::min(std::abs(pull.along(modulus.most_angle_deg) - modulus.most),
                           std::abs(pull.along(-modulus.most_angle_deg) - modulus.most)) < 1e-3);
            CHECK(modulus.least <= 80 * (1 + 1e-9));
        }
    }
}

TEST_CASE(
    "a membrane's modulus does not depend on how fine its mesh is; a bare spring's force per strain does",
    "[cloth]") {
    const auto mean = [](StretchModel model, int divisions) {
        return Pull(make_cloth(square(divisions), fabric_of(model))).mean();
    };
    CHECK(mean(StretchModel::membrane, 4) == Approx(mean(StretchModel::membrane, 16)).epsilon(1e-5));
    CHECK(mean(StretchModel::force_per_strain, 16) > 3 * mean(StretchModel::force_per_strain, 4));
    CHECK(mean(StretchModel::spring_constant, 16) < 1.1 * mean(StretchModel::spring_constant, 4));
}

TEST_CASE("an equilateral membrane is as stiff in every direction, and inner vertices rest in any strain",
          "[cloth]") {
    const Cloth cloth = make_cloth(equilateral_sheet(8), fabric_of(StretchModel::membrane));
    Points x = cloth.mesh.rest;
    x.row(0) *= 1.001;
    const Points f = force_at(*make_force("edge springs", cloth), x);
    const int inner = 4 * 9 + 4;
    CHECK(f.col(inner).norm() < 1e-12);
    CHECK(f.col(4 * 9).norm() > 1e-3);
}

TEST_CASE("two masses on a spring with a damping ratio of one decay without swinging, as exp does",
          "[cloth]") {
    Fabric fabric = bare_springs(80);
    fabric.damping = 1;
    const Cloth cloth = make_cloth(
        plain_mesh(points_of({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {4, 4, 0}}), faces_of({{0, 1, 2}, {1, 3, 2}})),
        fabric);
    for (const Spring& spring : cloth.network.edges) {
        const double ma = cloth.mass[spring.a], mb = cloth.mass[spring.b];
        const double omega = std::sqrt(spring.stiffness * (ma + mb) / (ma * mb)), step = 1e-4 / omega;
        double a = 0, b = spring.rest_length + 0.1, va = 0, vb = 0;
        for (int i = 1; i <= 50'000; ++i) {
            const double tension =
                spring.stiffness * (b - a - spring.rest_length) + spring.damping * (vb - va);
            va += step * tension / ma;
            vb -= step * tension / mb;
            a += step * va;
            b += step * vb;
            if (i % 10'000 != 0) continue;
            const double t = omega * step * i;
            CHECK(b - a - spring.rest_length ==
                  Approx(0.1 * (1 + t) * std::exp(-t)).margin(2e-5));  // measured: 4e-6, the step's
        }
    }
    fabric.damping = 0.25;
    const Cloth weaker = make_cloth(cloth.mesh, fabric);
    CHECK(weaker.network.edges[0].damping == Approx(0.25 * cloth.network.edges[0].damping));
}
