#include "simulate/stable_step.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

namespace drape {

namespace {

constexpr int fewest_rounds = 8, most_rounds = 24;
constexpr double converged = 1e-3;  // relative growth in the last round

// Every free vertex moved, unlike its neighbours: something of every mode is in it.
Points rough_mode(const Model& model) {
    Points mode(3, model.vertices());
    std::mt19937 random(1);
    for (Eigen::Index i = 0; i < mode.cols(); ++i)
        for (int c = 0; c < 3; ++c)
            mode(c, i) = model.inverse_mass[i] > 0 ? double(random()) / double(std::mt19937::max()) - 0.5 : 0;
    return mode;
}

// The largest eigenvalue of an operator that is symmetric where vertices are weighed by their mass, by
// Lanczos iteration. `apply` is called with a mode of norm 1 and what to set.
template <class Apply>
double largest_eigenvalue(const Model& model, Apply apply) {
    const auto product = [&](const Points& a, const Points& b) {
        return a.cwiseProduct(b).colwise().sum().dot(model.mass.transpose());
    };
    Points mode = rough_mode(model), last = Points::Zero(3, mode.cols()), next;
    Eigen::VectorXd diagonal(most_rounds), beside(most_rounds);
    double size = std::sqrt(product(mode, mode)), largest = 0;
    for (int round = 0; round < most_rounds && size > 1e-6 * largest; ++round) {
        mode /= size;
        apply(mode, next);
        diagonal[round] = product(next, mode);
        next -= diagonal[round] * mode + (round > 0 ? size : 0) * last;
        last = mode;
        mode = next;
        size = std::sqrt(product(mode, mode));
        beside[round] = size;
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
        solver.computeFromTridiagonal(diagonal.head(round + 1), beside.head(round), Eigen::EigenvaluesOnly);
        const double before = largest;
        largest = std::max(solver.eigenvalues()[round], 0.0);
        if (round >= fewest_rounds && largest < (1 + converged) * before) break;
    }
    return largest;
}

}  // namespace

Spectrum gershgorin_spectrum(const Dynamics& dynamics, In x, ForceShare share) {
    const StepBound bound = dynamics.bound(x, share);
    const Eigen::VectorXd& inverse_mass = dynamics.model().inverse_mass;
    return {std::sqrt(bound.stiffness.cwiseProduct(inverse_mass).maxCoeff()),
            bound.damping.cwiseProduct(inverse_mass).maxCoeff()};
}

double measured_omega(Dynamics& dynamics, In x, ForceShare share) {
    // a difference of accelerations over a way far below an edge, far above round-off
    const double extent = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).norm();
    const double reach = std::max(1e-7 * extent, 1e-9 * x.cwiseAbs().maxCoeff());
    Points here, moved;
    dynamics.acceleration_without_contact(x, here, share);
    return std::sqrt(largest_eigenvalue(dynamics.model(), [&](const Points& mode, Points& next) {
        const double way = reach / std::sqrt(mode.colwise().squaredNorm().maxCoeff());
        dynamics.acceleration_without_contact(x + way * mode, moved, share);
        next = (here - moved) / way;
    }));
}

double measured_gamma(Dynamics& dynamics, In x, ForceShare share) {
    Points still, moving;
    dynamics.linearly_damped_acceleration(x, Points::Zero(3, x.cols()), still, share);
    const double linear = largest_eigenvalue(dynamics.model(), [&](const Points& mode, Points& next) {
        dynamics.linearly_damped_acceleration(x, mode, moving, share);
        next = still - moving;
    });
    const Eigen::VectorXd rows = dynamics.nonlinear_bound(x, share).damping;
    return linear + rows.cwiseProduct(dynamics.model().inverse_mass).maxCoeff();
}

Spectrum with_contact(const Spectrum& spectrum, const ContactLimits& limits) {
    return {std::sqrt(spectrum.omega * spectrum.omega + limits.omega_squared), spectrum.gamma + limits.gamma};
}

}  // namespace drape
