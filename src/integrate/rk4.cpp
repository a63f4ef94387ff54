// The classical Runge-Kutta method of order four, at the step that is asked. Not symplectic: near its limit
// it damps the fast modes, by |R|^2 = 1 - (h w)^6 / 72 + (h w)^8 / 576 a step in energy.
#include "integrate/kinds.h"
#include "integrate/runge_kutta.h"

namespace drape {

namespace {

class Rk4 final : public Integrator {
public:
    void begin(Dynamics& dynamics, State& state, double) override { rule_.start(dynamics, state); }
    bool step(Dynamics& dynamics, State& state, double h) override {
        return rule_.advance(dynamics, state, h);
    }

private:
    RungeKutta4 rule_;
};

}  // namespace

std::unique_ptr<Integrator> make_rk4() {
    return std::make_unique<Rk4>();
}

double rk4_longest_step(const Spectrum& s) {
    return RungeKutta4::longest_step(s);
}

}  // namespace drape
