// Newton's method for a stage: with the exact Hessian where that is positive definite, else with each
// element's negative eigenvalues cut off.
#pragma once

#include "integrate/implicit_stage.h"
#include "integrate/step_matrix.h"

namespace drape {

class NewtonSolver final : public StageSolver {
public:
    explicit NewtonSolver(Dynamics& dynamics) : StageSolver(dynamics), matrix_(dynamics) {}

    SolverWork work() const override { return {matrix_.factorisations(), iterations_}; }

private:
    void begin(const ImplicitStage& stage) override;
    Outcome improve(const ImplicitStage& stage, int round) override;
    int most_rounds() const override { return 200; }
    bool leap(const ImplicitStage& stage, double most, int tried) override;
    Points direction(const ImplicitStage& stage, const Trial& at);

    StepMatrix matrix_;
    double last_move_ = 0;  // of the last Newton step [m]
    bool cut_ = false;      // the exact Hessian was indefinite; until a full step succeeds
    int patience_ = 0;      // leaps that may still fail
    long iterations_ = 0;
};

}  // namespace drape
