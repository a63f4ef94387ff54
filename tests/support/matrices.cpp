#include "support/matrices.h"

#include <Eigen/Eigenvalues>

namespace drape::test {

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& matrix) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>((matrix + matrix.transpose()) / 2,
                                                          Eigen::EigenvaluesOnly)
        .eigenvalues();
}

Eigen::MatrixXd dense(const BlockMatrix& matrix, Eigen::Index vertices) {
    Eigen::MatrixXd columns(3 * vertices, 3 * vertices);
    Points unit = Points::Zero(3, vertices);
    for (Eigen::Index i = 0; i < unit.size(); ++i) {
        unit.data()[i] = 1;
        columns.col(i) = matrix.multiply(unit).reshaped();
        unit.data()[i] = 0;
    }
    return columns;
}

Eigen::MatrixXd dense(const Majorant& majorant, Eigen::Index vertices) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * vertices, 3 * vertices);
    for (const auto& entry : majorant.entries()) {
        const Eigen::Index i = 3 * entry.row(), j = 3 * entry.col();
        matrix.block<3, 3>(i, j).diagonal().array() += entry.value();
        if (i != j) matrix.block<3, 3>(j, i).diagonal().array() += entry.value();
    }
    return matrix;
}

Eigen::MatrixXd minus_jacobian(const std::function<Points(In)>& f, Points x, double h, const Model& model) {
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
