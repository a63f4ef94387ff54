// Backward Euler with one Newton step (Baraff and Witkin): forces are linearised at the start of the step.
// With K = -df/dx, B = -df/dv there, and x1 = x0 + h v0 + d,
//   (M / h^2 + B / h + K) d = f(x0, v0, t1) - h K v0,   v1 = (x1 - x0) / h
// One solve a step; but one that bends or stretches much ends where nothing is in balance. K is taken without
// each element's negative eigenvalues, which leaves the order at one and the matrix always definite.
// Friction's impulses follow on the new velocities. A step that goes through an obstacle has failed, and so
// has one that closes in by more than a part of the gap: a barrier is not linear.
#include "integrate/kinds.h"
#include "integrate/step_matrix.h"

namespace drape {

namespace {

class BackwardEuler1 final : public Integrator {
public:
    void begin(Dynamics& dynamics, State& state, double) override {
        if (!matrix_) matrix_ = std::make_unique<StepMatrix>(dynamics);
        dynamics.acceleration(state.x, state.v, state.time, a_);
    }
    bool step(Dynamics& dynamics, State& state, double h) override {
        const Model& model = dynamics.model();
        state.time += h;
        place_pins(model, state);
        Contact* contact = dynamics.contact();
        if (contact) contact->cover(state.x, state.time, 0);
        dynamics.acceleration(state.x, state.v, state.time, a_);
        const ObstacleContact::Result& touch = dynamics.touch();
        if (touch.crossed || h * touch.limits.closing_rate > 1 ||
            !matrix_->factorise(dynamics, state.x, state.v, state.time, h,
                                StepMatrix::Curvature::semidefinite))
            return false;
        const Points force = a_ * model.mass.asDiagonal();
        state.v += matrix_->solve(force - h * matrix_->stiffness_times_velocity()) / h;
        dynamics.rub(state, h);

        Points move = h * state.v;
        for (Eigen::Index i = 0; i < move.cols(); ++i)
            if (model.inverse_mass[i] == 0) move.col(i).setZero();
        if (!move.allFinite()) return false;
        if (contact) {
            contact->cover(state.x, state.time, std::sqrt(move.colwise().squaredNorm().maxCoeff()));
            if (contact->clear_part(state.x, move, state.time) < 1) return false;
        }
        state.x += move;
        dynamics.acceleration(state.x, state.v, state.time, a_);
        dynamics.book(h);
        ++steps_;
        return true;
    }
    SolverWork work() const override { return {matrix_ ? matrix_->factorisations() : 0, steps_}; }

private:
    std::unique_ptr<StepMatrix> matrix_;
    Points a_;
    long steps_ = 0;
};

}  // namespace

std::unique_ptr<Integrator> make_backward_euler_1() {
    return std::make_unique<BackwardEuler1>();
}

}  // namespace drape
