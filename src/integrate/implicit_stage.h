// One stage of an implicit method: find x with
//   x = xp + c v,   v = vp + c a(x, v, t)
// pins at their places at t. Backward Euler, BDF2 and both stages of TR-BDF2 are such stages. Without
// velocities in the forces the solution is a minimum of
//   Phi(x) = |x - xp - c vp|^2_M / (2 c^2) + E(x, t)
// and friction adds c times its potential. Phi is lowered round by round along directions that each way to
// solve chooses (newton_stage.h, projective_dynamics.cpp), with a line search (Armijo). The work of forces
// that have no potential (damping, wind) is taken along the line by the trapezoid rule. No step goes through
// an obstacle: each contact point keeps a tenth of its gap.
#pragma once

#include <memory>

#include "integrate/method.h"

namespace drape {

struct ImplicitStage {
    Points xp, vp;    // [m], [m/s]
    double c = 0;     // [s]
    double time = 0;  // t, at the stage's end [s]
};

class StageSolver {
public:
    explicit StageSolver(Dynamics& dynamics) : dynamics_(dynamics) {}
    virtual ~StageSolver() = default;

    // a at the start of steps of h, friction included
    void first_acceleration(const State& state, double h, Points& a);

    // From a state before the stage to the solution. False if it found none; the state is then as it was.
    // Leaves the dynamics' power, contact limits and held friction those of the solution.
    bool solve(const ImplicitStage& stage, State& state);

    // (v - vp) / c of the last solution: unlike a(x, v, t) it does not magnify what error the solution has
    const Points& acceleration() const { return acceleration_; }

    virtual SolverWork work() const = 0;

protected:
    struct Trial {
        Points x, v;
        double potential = 0;  // Phi [J]
        Points residual;       // minus its gradient, with all forces; 0 at pins [N]
        Points driving;        // forces without a potential [N]
    };
    // fills all but x; false where x is not possible
    bool evaluate(const ImplicitStage& stage, Trial& trial);
    double rise(const Trial& from, const Trial& to) const;  // of Phi, less the work of driving forces [J]
    // Moves now_ by as much of the direction as lowers Phi enough, and sets `length` to how much that was;
    // next_ is then where it was. False if no part of it does.
    bool search(const ImplicitStage& stage, const Points& direction, double& length);
    // The same without a look at Phi; where that is not possible, nothing is moved.
    void take(const ImplicitStage& stage, const Points& direction);
    // Nothing that is left to do moves a vertex, or accelerates it, by as much as matters.
    bool is_settled(const ImplicitStage& stage) const;
    // Far below any method's own error; where rounding ends the progress earlier, the second will do [m].
    double fine_move(const ImplicitStage& stage) const;
    double coarse_move(const ImplicitStage& stage) const;

    Dynamics& dynamics_;
    Trial now_, next_;

    enum class Outcome { moved, converged, stuck };

private:
    // What a way to solve is: before a stage; one round, the first being number 0, which takes now_ to
    // something better; how many rounds it may take.
    virtual void begin(const ImplicitStage& stage) = 0;
    virtual Outcome improve(const ImplicitStage& stage, int round) = 0;
    virtual int most_rounds() const = 0;
    // Moves next_, where a whole step led that was not good enough, to something that may be; false if there
    // is nothing. `tried`: how often it did for this step.
    virtual bool leap(const ImplicitStage& stage, double most, int tried) = 0;

    bool start(const ImplicitStage& stage, const State& state);
    bool is_better(const Points& direction, double length) const;
    double clear_part(const ImplicitStage& stage, const Points& direction);  // of it, of obstacles
    bool settle(const ImplicitStage& stage);  // rounds under the normal forces that friction holds
    double typical_move(const ImplicitStage& stage) const;  // of a vertex, RMS [m]

    Points pin_velocity_, acceleration_, scratch_;
};

// The longest way of any vertex [m].
double largest_move(In move);

// x and v by a step h of TR-BDF2; `a` is the acceleration at the start, and at the end on return.
bool tr_bdf2_step(Dynamics& dynamics, StageSolver& solver, State& state, Points& a, double h);

}  // namespace drape
