// Backward Euler: x1 = x0 + h v1, v1 = v0 + h a(x1, v1, t1), solved to the end. Order one, stable at any
// step. Each step goes to a minimum of inertia and energy, so the energy never rises but by what is put in;
// motion slower than the step is damped as if by a force, by a part (h w)^2 / 2 of its energy a step.
#include "integrate/kinds.h"
#include "integrate/staged_integrator.h"

namespace drape {

namespace {

class BackwardEuler final : public StagedIntegrator {
public:
    using StagedIntegrator::StagedIntegrator;

    void begin(Dynamics& dynamics, State& state, double) override {
        dynamics.acceleration(state.x, state.v, state.time, a_);
        dynamics.hold_friction();
    }
    bool step(Dynamics& dynamics, State& state, double h) override {
        from_ = state.x;
        if (!solver(dynamics).solve({state.x, state.v, h, state.time + h}, state)) return false;
        dynamics.book_move(from_, state.x, state.v, state.time, h);
        return true;
    }

private:
    Points a_, from_;
};

}  // namespace

std::unique_ptr<Integrator> make_backward_euler_with(MakeSolver make) {
    return std::make_unique<BackwardEuler>(make);
}

std::unique_ptr<Integrator> make_backward_euler() {
    return make_backward_euler_with(make_newton_solver);
}

}  // namespace drape
