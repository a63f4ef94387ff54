#include "simulate/stable_step.h"

#include <cmath>

namespace drape {

Spectrum gershgorin_spectrum(const Dynamics& dynamics, In x) {
    const StepBound bound = dynamics.bound(x);
    const Eigen::VectorXd& inverse_mass = dynamics.model().inverse_mass;
    return {std::sqrt(bound.stiffness.cwiseProduct(inverse_mass).maxCoeff()),
            bound.damping.cwiseProduct(inverse_mass).maxCoeff()};
}

double measured_omega(Dynamics& dynamics, In x, double time, Points& mode, int iterations) {
    // a difference of accelerations over a way far below an edge, far above round-off
    const double reach = 1e-7 * (1 + x.cwiseAbs().maxCoeff());
    Points plus, minus;
    double omega_squared = 0;
    for (int i = 0; i < iterations; ++i) {
        const double largest = std::sqrt(mode.colwise().squaredNorm().maxCoeff());
        if (!(largest > 0)) return 0;
        mode *= reach / largest;
        dynamics.conservative_acceleration(x + mode, time, plus);
        dynamics.conservative_acceleration(x - mode, time, minus);
        const Points image = (minus - plus) / 2;
        // in the norm that makes M^-1 K symmetric
        const Eigen::VectorXd& m = dynamics.model().mass;
        const double size = (mode.colwise().squaredNorm() * m).value();
        const double next = (image.colwise().squaredNorm() * m).value();
        omega_squared = std::sqrt(next / size);
        mode = image;
    }
    return std::sqrt(omega_squared);
}

Spectrum with_contact(const Spectrum& spectrum, const ContactLimits& limits) {
    return {std::sqrt(spectrum.omega * spectrum.omega + limits.omega_squared), spectrum.gamma + limits.gamma};
}

}  // namespace drape
