// Velocity Verlet: kick h/2, drift h, kick h/2 with a = a(x, v, t) at the new positions.
//
// Forces that depend on velocity are taken at v + h/2 a(old), known before the kick and off by O(h^2), which
// keeps the order at two with one sweep a step. For a mode x'' = -w^2 x - g x' the velocity is thereby
// extrapolated, 3/2 v(n+1/2) - 1/2 v(n-1/2), and with z the factor per step
//   z^3 - 2 z^2 + z + (h w)^2 z^2 + h g (3/2 z^2 - 2 z + 1/2) = 0,
// which leaves the unit circle at z = -1, where (h w)^2 + 4 h g = 4. So
// h <= 2 / (g + sqrt(g^2 + w^2)).
#include <cmath>
#include <utility>

#include "integrate/kinds.h"

namespace drape {

namespace {

class Verlet final : public Integrator {
public:
    void begin(Dynamics& dynamics, State& state, double) override {
        dynamics.acceleration_to_kick(state.x, state.v, state.time, a_);
    }
    bool step(Dynamics& dynamics, State& state, double h) override {
        dynamics.book(h / 2);
        kick(dynamics, state, a_, h / 2);
        drift(dynamics, state, h);
        if (dynamics.is_conservative()) {
            dynamics.conservative_acceleration(state.x, state.time, a_);
        } else {
            ahead_ = state.v + h / 2 * a_;
            dynamics.acceleration_to_kick(state.x, ahead_, state.time, a_);
        }
        dynamics.book(h / 2);
        kick(dynamics, state, a_, h / 2);
        return true;
    }

private:
    Points a_, ahead_;
};

}  // namespace

std::unique_ptr<Integrator> make_verlet() {
    return std::make_unique<Verlet>();
}

double verlet_longest_step(const Spectrum& s) {
    // h^2 w^2 + 4 h g = 4, solved for h without cancellation
    return 2 / (s.gamma + std::hypot(s.gamma, s.omega));
}

}  // namespace drape
