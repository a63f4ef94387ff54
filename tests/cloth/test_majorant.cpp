#include "cloth/majorant.h"

#include <array>
#include <catch2/catch.hpp>

#include "support/cloths.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("a majorant is the matrix of the sum of its terms", "[cloth]") {
    Majorant majorant;
    majorant.add_difference(3, 1, 5);
    majorant.weigh(2);
    majorant.add_point(std::array{0, 3, 2}, std::array{0.5, -1.0, 0.7}, 3);
    majorant.add_diagonal(2, 4);
    majorant.add_entry(0, 1, 0.3);
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    for (const auto& entry : majorant.entries()) {
        CHECK(entry.row() >= entry.col());
        matrix(entry.row(), entry.col()) += entry.value();
        if (entry.row() != entry.col()) matrix(entry.col(), entry.row()) += entry.value();
    }
    for (unsigned seed = 1; seed < 5; ++seed) {
        const Eigen::Vector4d u = random_points(4, 1, seed).row(0).transpose();
        const double sum = 5 * std::pow(u[3] - u[1], 2) + 6 * std::pow(0.5 * u[0] - u[3] + 0.7 * u[2], 2) +
                           8 * u[2] * u[2] + 2 * 2 * 0.3 * u[0] * u[1];
        CHECK(u.dot(matrix * u) == Approx(sum));
    }
}
