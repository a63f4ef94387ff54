// A bound on an implicit step's matrix M / c^2 + B / c + K that does not change with the pose, and its
// Cholesky factor: n x n over the free vertices, felt by each coordinate alone (cloth/majorant.h). Only
// contact and friction are put in as they are, on the diagonal.
#pragma once

#include <Eigen/SparseCholesky>

#include "integrate/method.h"

namespace drape {

class MajorantMatrix {
public:
    explicit MajorantMatrix(const Dynamics& dynamics);

    // Factors M / c^2 + B / c + K + diag(contact), unless the last factor is of that already.
    void factorise(double c, const Eigen::VectorXd& contact);
    // The same, unless the last factor is of the same c and within a factor of two of each diagonal entry.
    void follow(double c, const Eigen::VectorXd& contact);

    // Right hand side and solution per vertex, 0 at pinned ones.
    Points solve(In right) const;

    long factorisations() const { return factorisations_; }

private:
    using Matrix = Eigen::SparseMatrix<double>;

    void fill(double c);
    Eigen::VectorXd of_free(const Eigen::VectorXd& values) const;

    std::vector<int> vertex_;  // the free ones
    Eigen::VectorXd mass_;     // of those [kg]
    Matrix stiffness_, damping_, matrix_;
    Eigen::VectorXd diagonal_, contact_;  // of the matrix without contact; of contact in the factor
    double c_ = 0;                        // of the factor [s]; 0: there is none
    Eigen::SimplicialLLT<Matrix, Eigen::Lower> factor_;
    long factorisations_ = 0;
};

}  // namespace drape
