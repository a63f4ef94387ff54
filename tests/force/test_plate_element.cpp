#include "force/plate_element.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

using namespace drape;

namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;

// lies in the plane y = 0, corners in the order of a front side
const std::array<Vec3, 3> corner{Vec3(0.1, 0, 0.2), Vec3(0.3, 0, 0.9), Vec3(0.8, 0, 0.1)};
constexpr double rigidity = 2, poisson = 0.3;

// w = a u^2/2 + b u v + c v^2/2 over (u, v) = (x, z)
Vec6 values_of(double a, double b, double c) {
    Vec6 d;
    const Vec3 centre = (corner[0] + corner[1] + corner[2]) / 3;
    for (size_t i = 0; i < 3; ++i) {
        const double u = corner[i].x(), v = corner[i].z();
        d[static_cast<Eigen::Index>(i)] = a * u * u / 2 + b * u * v + c * v * v / 2;
        const Vec3 begin = corner[(i + 1) % 3], end = corner[(i + 2) % 3], middle = (begin + end) / 2;
        Vec3 out = (end - begin).cross(Vec3::UnitY()).normalized();
        if (out.dot(centre - begin) > 0) out = -out;
        d[static_cast<Eigen::Index>(3 + i)] =
            out.x() * (a * middle.x() + b * middle.z()) + out.z() * (b * middle.x() + c * middle.z());
    }
    return d;
}

}  // namespace

TEST_CASE("a plate's triangle stores Kirchhoff's energy for quadratic deflections and none for flat ones",
          "[force]") {
    const Matrix6 k = plate_stiffness(corner, rigidity, poisson, {});
    const double a = 0.7, b = -0.4, c = 1.1;
    const Vec6 bent = values_of(a, b, c);
    const double area = (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm() / 2;
    const double density = (a + c) * (a + c) - 2 * (1 - poisson) * (a * c - b * b);
    CHECK(bent.dot(k * bent) / 2 == Approx(0.5 * rigidity * area * density));
    CHECK((k - k.transpose()).norm() < 1e-14 * k.norm());
    CHECK(Eigen::SelfAdjointEigenSolver<Matrix6>(k).eigenvalues().head<3>().cwiseAbs().maxCoeff() <
          1e-14 * k.norm());
}

TEST_CASE("free slopes of a plate's triangle take the values of least energy", "[force]") {
    const Matrix6 whole = plate_stiffness(corner, rigidity, poisson, {});
    Vec6 d = values_of(0.7, -0.4, 1.1);
    SECTION("one edge") {
        const Matrix6 k = plate_stiffness(corner, rigidity, poisson, {false, true, false});
        const double energy = d.dot(k * d);
        d[4] = 0;
        d[4] = -whole.row(4).dot(d) / whole(4, 4);
        CHECK(d.dot(whole * d) == Approx(energy));
        CHECK(k.row(4).norm() + k.col(4).norm() == 0);
    }
    SECTION("two edges") {
        const Matrix6 k = plate_stiffness(corner, rigidity, poisson, {false, true, true});
        const double energy = d.dot(k * d);
        d.tail<2>().setZero();
        d.tail<2>() = -whole.bottomRightCorner<2, 2>().llt().solve((whole * d).tail<2>());
        CHECK(d.dot(whole * d) == Approx(energy));
    }
    SECTION("a lone triangle cannot bend") {
        CHECK(plate_stiffness(corner, rigidity, poisson, {true, true, true}).norm() == 0);
    }
}
