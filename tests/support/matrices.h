// Stiffness and damping as dense matrices, and what they are held to.
#pragma once

#include "cloth/block_matrix.h"
#include "support/gradient.h"

namespace drape::test {

// All 3n rows in the order of the State's columns; zero at pinned vertices.
inline Eigen::MatrixXd dense(const BlockMatrix& matrix, Eigen::Index vertices) {
    Eigen::MatrixXd columns(3 * vertices, 3 * vertices);
    Points unit = Points::Zero(3, vertices);
    for (Eigen::Index i = 0; i < unit.size(); ++i) {
        unit.data()[i] = 1;
        columns.col(i) = matrix.multiply(unit).reshaped();
        unit.data()[i] = 0;
    }
    return columns;
}

// -df/dx of a map of all coordinates by central differences of fourth order; zero in rows and columns of
// pinned vertices.
inline Eigen::MatrixXd minus_jacobian(const std::function<Points(In)>& f, Points x, double h,
                                      const Model& model) {
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(x.size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        if (model.inverse_mass[i / 3] == 0) continue;
        double& value = x.data()[i];
        const double kept = value;
        const auto at = [&](double offset) {
            value = kept + offset;
            return f(x);
        };
        const Points change = (8 * (at(-h) - at(h)) - (at(-2 * h) - at(2 * h))) / (12 * h);
        value = kept;
        columns.col(i) = change.reshaped();
    }
    for (Eigen::Index v = 0; v < x.cols(); ++v)
        if (model.inverse_mass[v] == 0) columns.middleRows<3>(3 * v).setZero();
    return columns;
}

}  // namespace drape::test
