// One stage of an implicit method: find x with
//   x = xp + c v,   v = vp + c a(x, v, t)
// pins at their places at t. Backward Euler, BDF2 and both stages of TR-BDF2 are such stages. Without
// velocities in the forces the solution is a minimum of
//   Phi(x) = |x - xp - c vp|^2_M / (2 c^2) + E(x, t)
// and friction adds c times its potential. Phi is lowered by Newton's method with a line search (Armijo):
// with the exact Hessian where that is positive definite, else with each element's negative eigenvalues cut
// off. The work of forces that have no potential (damping, wind) is taken along the line by the trapezoid
// rule. No step goes through an obstacle: each contact point keeps a tenth of its gap.
#pragma once

#include "integrate/step_matrix.h"

namespace drape {

struct Stage {
    Points xp, vp;    // [m], [m/s]
    double c = 0;     // [s]
    double time = 0;  // t, at the stage's end [s]
};

class StageSolver {
public:
    explicit StageSolver(Dynamics& dynamics) : dynamics_(dynamics), matrix_(dynamics) {}

    // a at the start of steps of h, friction included
    void first_acceleration(const State& state, double h, Points& a);

    // From a state before the stage to the solution. False if it found none; the state is then as it was.
    // Leaves the dynamics' power, contact limits and held friction those of the solution.
    bool solve(const Stage& stage, State& state);

    // (v - vp) / c of the last solution: unlike a(x, v, t) it does not magnify what error the solution has
    const Points& acceleration() const { return acceleration_; }

    SolverWork work() const { return {matrix_.factorisations(), iterations_}; }

private:
    struct Trial {
        Points x, v;
        double potential = 0;  // Phi [J]
        Points residual;       // minus its gradient, with all forces; 0 at pins [N]
        Points driving;        // forces without a potential [N]
    };
    bool evaluate(const Stage& stage, Trial& trial);        // fills all but x; false where x is not possible
    double rise(const Trial& from, const Trial& to) const;  // of Phi, less the work of driving forces [J]
    bool start(const Stage& stage, const State& state);
    enum class Outcome { moved, converged, stuck };
    Outcome improve(const Stage& stage);
    bool is_better(const Points& direction, double length) const;
    Points newton_direction(const Stage& stage, const Trial& at);
    bool leap(const Stage& stage, double most);
    bool search(const Stage& stage, const Points& direction, double& length);
    bool settle(const Stage& stage);  // Newton's method under the normal forces that friction holds
    double typical_move(const Stage& stage) const;  // of a vertex, RMS [m]

    Dynamics& dynamics_;
    StepMatrix matrix_;
    Trial now_, next_;
    Points pin_velocity_, acceleration_, scratch_;
    double last_move_ = 0;  // of the last Newton step [m]
    bool cut_ = false;      // the exact Hessian was indefinite; until a full step succeeds
    int patience_ = 0;      // leaps that may still fail
    long iterations_ = 0;
};

// x and v by a step h of TR-BDF2; `a` is the acceleration at the start, and at the end on return.
bool tr_bdf2_step(Dynamics& dynamics, StageSolver& solver, State& state, Points& a, double h);

}  // namespace drape
