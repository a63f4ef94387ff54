// The matrix of an implicit step, M / c^2 + B / c + K over the free vertices, and its Cholesky factor. Its
// pattern is that of the cloth, and of the pairs of it that may touch: analysed once and whenever those
// change, filled again for every solve.
#pragma once

#include <Eigen/SparseCholesky>

#include "integrate/method.h"

namespace drape {

class StepMatrix {
public:
    explicit StepMatrix(const Dynamics& dynamics);

    // Exact stiffness, or each element without its negative eigenvalues: then the sum is positive definite.
    enum class Curvature { exact, semidefinite };

    // Fills the matrix at (x, v, time) and factors it. False if it is not positive definite.
    bool factorise(const Dynamics& dynamics, In x, In v, double time, double c, Curvature curvature);
    // Of the last matrix; right hand side and solution per vertex, 0 at pinned ones.
    Points solve(In right);

    // K v of the last matrix's stiffness alone
    const Points& stiffness_times_velocity() const { return stiff_velocity_; }

    long factorisations() const { return factorisations_; }

private:
    long version_;  // of the couplings
    BlockMatrix matrix_;
    // The vertices are numbered for a sparse factor already. CHOLMOD's simplicial factorisation of the same
    // matrices runs at 0.8 to 1.2 of this one's speed (README.md); its supernodal one goes through BLAS,
    // whose bits depend on the machine.
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
    Points stiff_velocity_, solution_;
    Eigen::VectorXd free_;
    long factorisations_ = 0;
};

}  // namespace drape
