#include "integrate/newton_stage.h"

#include <cmath>

namespace drape {

namespace {

constexpr int most_leaps = 12, most_failed_leaps = 8;

}  // namespace

void NewtonSolver::begin(const ImplicitStage&) {
    cut_ = false;
    patience_ = most_failed_leaps;
}

// Solves with the matrix at the trial; not finite where there is none.
Points NewtonSolver::direction(const ImplicitStage& stage, const Trial& at) {
    ++iterations_;
    const auto factorise = [&](StepMatrix::Curvature curvature) {
        return matrix_.factorise(dynamics_, at.x, at.v, stage.time, stage.c, curvature);
    };
    cut_ = cut_ || !factorise(StepMatrix::Curvature::exact);
    if (cut_ && !factorise(StepMatrix::Curvature::semidefinite)) return Points::Constant(3, at.x.cols(), NAN);
    return matrix_.solve(at.residual);
}

// A Newton step from there, no farther than `most`. A stiff spring keeps its length along a curve: a straight
// step leaves the valley of low energy, and this leads back to its floor farther on.
bool NewtonSolver::leap(const ImplicitStage& stage, double most, int tried) {
    if (patience_ == 0) return false;
    if (tried == most_leaps) {
        --patience_;
        return false;
    }
    const Points back = direction(stage, next_);
    bool possible = largest_move(back) < most;
    if (Contact* contact = dynamics_.contact(); possible && contact) {
        contact->cover(next_.x, stage.time, most);
        possible = contact->clear_part(next_.x, back, stage.time) == 1;
    }
    if (possible) {
        next_.x += back;
        possible = evaluate(stage, next_);
    }
    if (!possible) --patience_;
    return possible;
}

StageSolver::Outcome NewtonSolver::improve(const ImplicitStage& stage, int round) {
    if (round == 0) last_move_ = INFINITY;
    const double fine = fine_move(stage), coarse = coarse_move(stage);
    if (is_settled(stage)) return Outcome::converged;
    const Points way = direction(stage, now_);
    const double move = largest_move(way);
    if (!std::isfinite(move)) return Outcome::stuck;
    // so near the solution rounding hides from a search whether the energy falls
    if (move < fine) {
        take(stage, way);
        return Outcome::converged;
    }
    double length = 0;
    if (!search(stage, way, length)) {
        if (move < coarse) return Outcome::converged;
        if (cut_) return Outcome::stuck;
        cut_ = true;
        return Outcome::moved;
    }
    const bool stalled = move < coarse && move > last_move_ / 2;
    last_move_ = move;
    if (length < 1) return Outcome::moved;
    cut_ = false;
    return stalled ? Outcome::converged : Outcome::moved;
}

}  // namespace drape
