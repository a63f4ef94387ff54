// What the methods made of stages share: one solver, set up when a run begins, and its account.
#pragma once

#include <memory>

#include "integrate/implicit_stage.h"

namespace drape {

class StagedIntegrator : public Integrator {
public:
    SolverWork work() const final { return solver_ ? solver_->work() : SolverWork{}; }

protected:
    StageSolver& solver(Dynamics& dynamics) {
        if (!solver_) solver_ = std::make_unique<StageSolver>(dynamics);
        return *solver_;
    }

private:
    std::unique_ptr<StageSolver> solver_;
};

}  // namespace drape
