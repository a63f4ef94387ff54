// TR-BDF2: the trapezoid rule over g h, then BDF2 through the start, there and the end, g = 2 - sqrt 2:
//   xg = x0 + g h / 2 (v0 + vg)
//   x1 = xg / (g (2 - g)) - (1 - g)^2 / (g (2 - g)) x0 + (1 - g) / (2 - g) h v1,   and the same for v with a
// With this g both stages have the same c = g h / 2 and so the same matrix. Order two; L-stable: the fastest
// motion is gone after a step. It needs nothing from the step before.
#include <numbers>

#include "integrate/kinds.h"
#include "integrate/staged_integrator.h"

namespace drape {

bool tr_bdf2_step(Dynamics& dynamics, StageSolver& solver, State& state, Points& a, double h) {
    constexpr double g = 2 - std::numbers::sqrt2, c = g / 2, outer = std::numbers::sqrt2 / 4;
    // the weights of the three accelerations in v1 are `outer`, `outer` and c; power is summed alike
    dynamics.book(outer * h);
    const State start = state;
    if (!solver.solve({start.x + c * h * start.v, start.v + c * h * a, c * h, start.time + g * h}, state))
        return false;
    dynamics.book(outer * h);
    constexpr double inner = 1 / (g * (2 - g)), old = (1 - g) * (1 - g) * inner;
    if (!solver.solve(
            {inner * state.x - old * start.x, inner * state.v - old * start.v, c * h, start.time + h}, state))
        return false;
    dynamics.book(c * h);
    a = solver.acceleration();
    return true;
}

namespace {

class TrBdf2 final : public StagedIntegrator {
public:
    void begin(Dynamics& dynamics, State& state, double h) override {
        solver(dynamics).first_acceleration(state, h, a_);
    }
    bool step(Dynamics& dynamics, State& state, double h) override {
        return tr_bdf2_step(dynamics, solver(dynamics), state, a_, h);
    }

private:
    Points a_;
};

}  // namespace

std::unique_ptr<Integrator> make_tr_bdf2() {
    return std::make_unique<TrBdf2>();
}

}  // namespace drape
