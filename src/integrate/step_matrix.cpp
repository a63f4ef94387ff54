#include "integrate/step_matrix.h"

namespace drape {

StepMatrix::StepMatrix(const Dynamics& dynamics)
    : version_(0),
      matrix_(dynamics.model(), dynamics.couplings()),
      solution_(3, dynamics.model().vertices()) {
    factor_.analyzePattern(matrix_.lower());
}

bool StepMatrix::factorise(const Dynamics& dynamics, In x, In v, double time, double c, Curvature curvature) {
    if (const long version = dynamics.couplings_version(x, time); version != version_) {
        version_ = version;
        matrix_ = BlockMatrix(dynamics.model(), dynamics.couplings());
        factor_.analyzePattern(matrix_.lower());
    }
    const bool semidefinite = curvature == Curvature::semidefinite;
    matrix_.set_zero();
    matrix_.weigh(1, semidefinite);
    dynamics.add_stiffness(x, v, time, matrix_);
    stiff_velocity_ = matrix_.multiply(v);
    matrix_.weigh(1 / c, semidefinite);
    dynamics.add_damping(x, v, time, matrix_);
    dynamics.friction().add_damping(v, matrix_);
    matrix_.add_masses(1 / (c * c));
    ++factorisations_;
    factor_.factorize(matrix_.lower());
    return factor_.info() == Eigen::Success;
}

Points StepMatrix::solve(In right) {
    matrix_.gather(right, free_);
    matrix_.scatter(factor_.solve(free_), solution_);
    return solution_;
}

}  // namespace drape
