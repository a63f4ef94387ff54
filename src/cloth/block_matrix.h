// A symmetric matrix of 3x3 blocks over the vertices that can move, for implicit methods: stiffness, damping,
// masses, summed in place. Its pattern is fixed at construction; pinned vertices have no rows. Rows are in an
// order that keeps a factorisation sparse.
#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <utility>
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

    // Elements added from now on are multiplied by `factor`; with `semidefinite`, each is first replaced by
    // the nearest matrix without negative eigenvalues (in the Frobenius norm).
    void weigh(double factor, bool semidefinite);

    static constexpr int most_vertices = 4;  // of an element
    // 3 rows per vertex; only the lower triangle is read
    using Element = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3 * most_vertices,
                                  3 * most_vertices>;

    // K += factor k, rows in the order of `vertices`. All must be coupled; none may come twice.
    void add_element(std::span<const int> vertices, const Element& k);

    // K += factor w w' (x) k: a 3x3 matrix felt at a point that is the w-weighted sum of vertices
    void add_point(std::span<const int> vertices, std::span<const double> weights, const Mat3& k);

    // the block of vertices i and j, and of j and i, += factor value I. Not projected: for matrices that are
    // semidefinite as a whole.
    void add_isotropic(int i, int j, double value);

    // K += factor diag(mass), whatever the weight of elements
    void add_masses(double factor);

    // 3 x vertices; 0 at pinned ones
    Points multiply(In x) const;
    void gather(In x, Eigen::VectorXd& free) const;  // the free vertices' values in the matrix's order
    void scatter(const Eigen::VectorXd& free, Points& x) const;  // back; 0 at pinned ones

    // The lower triangle; its pattern never changes.
    const Eigen::SparseMatrix<double>& lower() const { return lower_; }

private:
    void number_vertices(const Model& model, const Couplings& couplings);
    void lay_out(const Couplings& couplings);
    // adds to the block of two places, row >= column; of a block on the diagonal its lower triangle
    void add_block(int row, int column, const Mat3& value);

    std::vector<int> place_;   // of each vertex among the free ones, in the matrix's order; -1 where pinned
    std::vector<int> vertex_;  // and back
    std::vector<int> first_block_, block_row_;  // of each column of blocks: its blocks' rows, ascending
    Eigen::VectorXd mass_;
    double factor_ = 1;
    bool semidefinite_ = false;
    Eigen::SparseMatrix<double> lower_;
};

}  // namespace drape
