// Symplectic Euler: v += h a(x, v, t), then x += h v. Order one; the same limit as Verlet without damping.
// With damping the velocity is that of the step before: (h w)^2 + 2 h g <= 4.
#include <cmath>

#include "integrate/kinds.h"

namespace drape {

namespace {

class SymplecticEuler final : public Integrator {
public:
    void begin(Dynamics& dynamics, State& state, double) override {
        dynamics.acceleration_to_kick(state.x, state.v, state.time, a_);
    }
    bool step(Dynamics& dynamics, State& state, double h) override {
        dynamics.book(h);
        kick(dynamics, state, a_, h);
        drift(dynamics, state, h);
        dynamics.acceleration_to_kick(state.x, state.v, state.time, a_);
        return true;
    }

private:
    Points a_;
};

}  // namespace

std::unique_ptr<Integrator> make_symplectic_euler() {
    return std::make_unique<SymplecticEuler>();
}

double symplectic_euler_longest_step(const Spectrum& s) {
    // h^2 w^2 + 2 h g = 4
    return 4 / (s.gamma + std::sqrt(s.gamma * s.gamma + 4 * s.omega * s.omega));
}

}  // namespace drape
