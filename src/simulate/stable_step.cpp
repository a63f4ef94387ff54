#include "simulate/stable_step.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

namespace drape {

namespace {

constexpr int fewest_rounds = 8, most_rounds = 24;
constexpr double converged = 1e-3;  // relative growth of omega squared in the last round

// Every free vertex moved, unlike its neighbours: something of every mode is in it.
Points rough_mode(const Model& model) {
    Points mode(3, model.vertices());
    std::mt19937 random(1);
    for (Eigen::Index i = 0; i < mode.cols(); ++i)
        for (int c = 0; c < 3; ++c)
            mode(c, i) = model.inverse_mass[i] > 0 ? double(random()) / double(std::mt19937::max()) - 0.5 : 0;
    return mode;
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
    // in the norm that makes M^-1 K symmetric
    const Eigen::VectorXd& mass = dynamics.model().mass;
    const auto product = [&](const Points& a, const Points& b) {
        return a.cwiseProduct(b).colwise().sum().dot(mass.transpose());
    };
    Points here, moved, mode = rough_mode(dynamics.model()), last = Points::Zero(3, x.cols());
    dynamics.acceleration_without_contact(x, here, share);
    Eigen::VectorXd diagonal(most_rounds), beside(most_rounds);
    double size = std::sqrt(product(mode, mode)), fastest = 0;
    for (int round = 0; round < most_rounds && size > 1e-6 * fastest; ++round) {
        mode /= size;
        const double way = reach / std::sqrt(mode.colwise().squaredNorm().maxCoeff());
        dynamics.acceleration_without_contact(x + way * mode, moved, share);
        Points next = (here - moved) / way;
        diagonal[round] = product(next, mode);
        next -= diagonal[round] * mode + (round > 0 ? size : 0) * last;
        last = mode;
        mode = next;
        size = std::sqrt(product(mode, mode));
        beside[round] = size;
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
        solver.computeFromTridiagonal(diagonal.head(round + 1), beside.head(round), Eigen::EigenvaluesOnly);
        const double before = fastest;
        fastest = std::max(solver.eigenvalues()[round], 0.0);
        if (round >= fewest_rounds && fastest < (1 + converged) * before) break;
    }
    return std::sqrt(fastest);
}

Spectrum with_contact(const Spectrum& spectrum, const ContactLimits& limits) {
    return {std::sqrt(spectrum.omega * spectrum.omega + limits.omega_squared), spectrum.gamma + limits.gamma};
}

}  // namespace drape
