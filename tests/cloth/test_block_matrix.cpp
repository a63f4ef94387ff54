#include "cloth/block_matrix.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <catch2/catch.hpp>

#include "support/cloths.h"
#include "support/matrices.h"
#include "support/pins.h"

using namespace drape;
using namespace drape::test;

namespace {

// A sheet whose triangles couple, some vertices pinned, and random elements on them.
struct Elements {
    Model model = model_of(square(3), bare_springs(50));
    Couplings couplings;
    std::vector<std::array<int, 3>> vertices;
    std::vector<BlockMatrix::Element> elements;

    Elements() {
        hold(model, {0, 5, 12}, model.cloths[0].mesh.rest);
        const Faces& faces = model.cloths[0].mesh.faces;
        for (Eigen::Index f = 0; f < faces.cols(); ++f) {
            vertices.push_back({faces(0, f), faces(1, f), faces(2, f)});
            couplings.couple(vertices.back());
            const Points random = random_points(27, 1, 100 + static_cast<unsigned>(f));
            const Eigen::MatrixXd k = random.reshaped(9, 9);
            elements.emplace_back(k + k.transpose());
        }
    }
    Eigen::MatrixXd sum(double factor, bool semidefinite) const {
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(3 * model.vertices(), 3 * model.vertices());
        for (size_t e = 0; e < elements.size(); ++e) {
            Eigen::MatrixXd k = elements[e];
            if (semidefinite) {
                const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(k);
                k = modes.eigenvectors() * modes.eigenvalues().cwiseMax(0).asDiagonal() *
                    modes.eigenvectors().transpose();
            }
            for (int i = 0; i < 9; ++i)
                for (int j = 0; j < 9; ++j)
                    sum(3 * vertices[e][static_cast<size_t>(i / 3)] + i % 3,
                        3 * vertices[e][static_cast<size_t>(j / 3)] + j % 3) += factor * k(i, j);
        }
        return without_pins(sum);
    }
    Eigen::MatrixXd without_pins(Eigen::MatrixXd matrix) const {
        for (int v = 0; v < model.vertices(); ++v) {
            if (model.inverse_mass[v] > 0) continue;
            matrix.middleRows<3>(3 * v).setZero();
            matrix.middleCols<3>(3 * v).setZero();
        }
        return matrix;
    }
};

}  // namespace

TEST_CASE("a block matrix is the sum of its weighted elements, without the pinned vertices", "[cloth]") {
    const Elements e;
    BlockMatrix matrix(e.model, e.couplings);
    CHECK(matrix.lower().rows() == 3 * (16 - 3));
    for (const bool semidefinite : {false, true}) {
        matrix.set_zero();
        matrix.weigh(1.7, semidefinite);
        for (size_t i = 0; i < e.elements.size(); ++i) matrix.add_element(e.vertices[i], e.elements[i]);
        const Eigen::MatrixXd found = dense(matrix, 16), expected = e.sum(1.7, semidefinite);
        CHECK((found - expected).norm() < 1e-12 * expected.norm());
        CHECK(found == found.transpose());
    }
}

TEST_CASE("an element that is semidefinite already is not changed by projecting it", "[cloth]") {
    const Elements e;
    const Eigen::MatrixXd factor = random_points(18, 1, 5).reshaped(9, 6);
    const BlockMatrix::Element element = factor * factor.transpose();  // of rank 6
    BlockMatrix plain(e.model, e.couplings), projected(e.model, e.couplings);
    projected.weigh(1, true);
    plain.add_element(e.vertices[4], element);
    projected.add_element(e.vertices[4], element);
    CHECK(plain.lower().isApprox(projected.lower(), 1e-14));
}

TEST_CASE("points, isotropic blocks and masses are elements of their kinds", "[cloth]") {
    const Elements e;
    const std::array<int, 3> at =
        *std::find_if(e.vertices.begin(), e.vertices.end(), [&](const auto& corners) {
            return std::all_of(corners.begin(), corners.end(),
                               [&](int v) { return e.model.inverse_mass[v] > 0; });
        });
    const std::array<double, 3> w{0.5, 0.2, 0.3};
    Mat3 k;
    k << 1, 2, 3, 2, -5, 1, 3, 1, 4;
    BlockMatrix matrix(e.model, e.couplings);
    matrix.weigh(2, false);
    matrix.add_point(at, w, k);
    matrix.add_isotropic(at[0], at[1], 3.5);
    matrix.add_isotropic(at[2], at[2], -1);
    matrix.add_masses(10);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(48, 48);
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) expected.block<3, 3>(3 * at[i], 3 * at[j]) += 2 * w[i] * w[j] * k;
    expected.block<3, 3>(3 * at[0], 3 * at[1]) += 7 * Mat3::Identity();
    expected.block<3, 3>(3 * at[1], 3 * at[0]) += 7 * Mat3::Identity();
    expected.block<3, 3>(3 * at[2], 3 * at[2]) -= 2 * Mat3::Identity();
    for (int v = 0; v < 16; ++v)
        expected.block<3, 3>(3 * v, 3 * v) += 10 * e.model.mass[v] * Mat3::Identity();
    expected = e.without_pins(expected);
    CHECK((dense(matrix, 16) - expected).norm() < 1e-13 * expected.norm());
}

TEST_CASE("gathering and scattering undo each other on free vertices", "[cloth]") {
    const Elements e;
    const BlockMatrix matrix(e.model, e.couplings);
    const Points x = random_points(16, 1, 8);
    Points back(3, 16);
    Eigen::VectorXd free;
    matrix.gather(x, free);
    matrix.scatter(free, back);
    for (int v = 0; v < 16; ++v)
        CHECK(Vec3(back.col(v)) == (e.model.inverse_mass[v] > 0 ? Vec3(x.col(v)) : Vec3(0, 0, 0)));
}

TEST_CASE("a cloth held everywhere has a matrix of no rows", "[cloth]") {
    Model model = model_of(equilateral_triangle(), bare_springs(50));
    hold(model, {0, 1, 2}, model.cloths[0].mesh.rest);
    Couplings couplings;
    couplings.couple(std::array{0, 1, 2});
    BlockMatrix matrix(model, couplings);
    matrix.add_masses(1);
    CHECK(matrix.lower().rows() == 0);
    CHECK(matrix.multiply(model.cloths[0].mesh.rest).isZero(0));
}

TEST_CASE("the order of rows keeps factors sparse", "[cloth]") {
    const Model model = model_of(square(32), bare_springs(50));
    Couplings couplings;
    for (const Spring& edge : model.cloths[0].network.edges) couplings.couple(std::array{edge.a, edge.b});
    BlockMatrix matrix(model, couplings);
    matrix.add_masses(1);
    const auto entries = [&](auto& factor) {
        factor.analyzePattern(matrix.lower());
        factor.factorize(matrix.lower());
        const Eigen::SparseMatrix<double> l = factor.matrixL();
        return static_cast<double>(l.nonZeros());
    };
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> natural;
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::AMDOrdering<int>> reordered;
    CHECK(entries(natural) < 1.1 * entries(reordered));
}
