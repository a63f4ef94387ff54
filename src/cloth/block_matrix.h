// A symmetric matrix of 3x3 blocks over the vertices that can move, for implicit methods: stiffness, damping,
// masses, summed in place. Its pattern is fixed at construction; pinned vertices have no rows. Rows are in an
// order that keeps a factorisation sparse.
#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "cloth/model.h"

namespace drape {

// Which vertices act on each other directly. Every vertex acts on itself.
class Couplings {
public:
    void couple(std::span<const int> vertices);  // all with each other; columns of the State
    const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }

private:
    std::vector<std::pair<int, int>> pairs_;  // first > second; may repeat
};

class BlockMatrix {
public:
    BlockMatrix(const Model& model, const Couplings& couplings);

    void set_zero();

    // What is added from now on is multiplied by `factor`; with `semidefinite`, each element is first
    // replaced by the nearest matrix without negative eigenvalues (in the Frobenius norm).
    void weigh(double factor, bool semidefinite);

    // K += factor k, k symmetric, 3 rows per vertex in the order of `vertices`. All must be coupled.
    void add_element(std::span<const int> vertices, const Eigen::Ref<const Eigen::MatrixXd>& k);

    // the block of vertices i and j, and of j and i, += factor value I. Not projected: for matrices that are
    // semidefinite as a whole.
    void add_isotropic(int i, int j, double value);

    // K += factor diag(mass)
    void add_masses(double factor);

    // 3 x vertices; 0 at pinned ones
    Points multiply(In x) const;
    void gather(In x, Eigen::VectorXd& free) const;  // the free vertices' values in the matrix's order
    void scatter(const Eigen::VectorXd& free, Points& x) const;  // back; 0 at pinned ones

    // The lower triangle.
    const Eigen::SparseMatrix<double>& lower() const { return lower_; }

private:
    double* block(int row, int column);  // first of its three columns' entries

    std::vector<int> place_;   // of each vertex among the free ones, in the matrix's order; -1 where pinned
    std::vector<int> vertex_;  // and back
    const Eigen::VectorXd mass_;
    double factor_ = 1;
    bool semidefinite_ = false;
    Eigen::SparseMatrix<double> lower_;
};

}  // namespace drape
