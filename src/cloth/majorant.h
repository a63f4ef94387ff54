// Bounds on curvature that hold at every pose (or as far as each force says) and are the same for the three
// coordinates: a sum of terms
//   1/2 c |x_i - x_j|^2   and   1/2 c |sum_k w_k x_k|^2
// whose matrix, n x n and felt by each coordinate alone, less the Hessian of an energy has no negative
// eigenvalue. For methods that step with one constant matrix (integrate/projective_dynamics.cpp).
#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

namespace drape {

class Majorant {
public:
    // Terms added from now on are multiplied by `factor`.
    void weigh(double factor) { factor_ = factor; }

    void add_diagonal(int i, double c) { add_entry(i, i, c); }
    void add_difference(int i, int j, double c);  // c |x_i - x_j|^2 / 2
    void add_point(std::span<const int> vertices, std::span<const double> weights, double c);
    // of a matrix that is semidefinite as a whole: at (i, j), and at (j, i)
    void add_entry(int i, int j, double value);

    // lower triangle, columns of the State; places may repeat
    const std::vector<Eigen::Triplet<double>>& entries() const { return entries_; }

private:
    double factor_ = 1;
    std::vector<Eigen::Triplet<double>> entries_;
};

}  // namespace drape
