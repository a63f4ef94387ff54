// What the methods made of stages share: one solver, set up when a run begins, and its account.
#pragma once

#include <memory>

#include "integrate/newton_stage.h"

namespace drape {

using MakeSolver = std::unique_ptr<StageSolver> (*)(Dynamics&);

inline std::unique_ptr<StageSolver> make_newton_solver(Dynamics& dynamics) {
    return std::make_unique<NewtonSolver>(dynamics);
}

class StagedIntegrator : public Integrator {
public:
    explicit StagedIntegrator(MakeSolver make = make_newton_solver) : make_(make) {}

    SolverWork work() const final { return solver_ ? solver_->work() : SolverWork{}; }

protected:
    StageSolver& solver(Dynamics& dynamics) {
        if (!solver_) solver_ = make_(dynamics);
        return *solver_;
    }

private:
    MakeSolver make_;
    std::unique_ptr<StageSolver> solver_;
};

// Backward Euler, its steps solved in that way.
std::unique_ptr<Integrator> make_backward_euler_with(MakeSolver make);

}  // namespace drape
