#include "integrate/implicit_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace drape {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr int most_halvings = 30, most_friction_rounds = 4;
constexpr double enough = 1e-4;                             // of the descent that the slope promises (Armijo)
constexpr double fine_length = 1e-10, fine_part = 1e-7;     // [m]; of what a vertex moves in a stage
constexpr double coarse_length = 1e-7, coarse_part = 1e-4;  // the same
constexpr double fine_acceleration = 1e-5;                  // [m/s^2], a millionth of the Earth's

}  // namespace

double largest_move(In move) {
    return std::sqrt(move.colwise().squaredNorm().maxCoeff());
}

double StageSolver::typical_move(const ImplicitStage& stage) const {
    return stage.c * std::sqrt(now_.v.colwise().squaredNorm().mean());
}

bool StageSolver::evaluate(const ImplicitStage& stage, Trial& trial) {
    const Model& model = dynamics_.model();
    trial.v = (trial.x - stage.xp) / stage.c;
    for (Eigen::Index i = 0; i < trial.v.cols(); ++i)
        if (model.inverse_mass[i] == 0) trial.v.col(i) = pin_velocity_.col(i);
    trial.potential =
        dynamics_.potential_energy(trial.x, stage.time) + stage.c * dynamics_.friction().potential(trial.v);
    if (!std::isfinite(trial.potential)) return false;

    dynamics_.acceleration_with_friction(trial.x, trial.v, stage.time, trial.residual);
    trial.driving.setZero(3, trial.x.cols());
    if (!dynamics_.is_conservative()) {
        dynamics_.friction().add_force(trial.v, trial.driving);
        dynamics_.conservative_acceleration(trial.x, stage.time, scratch_);
        trial.driving = (trial.residual - scratch_) * model.mass.asDiagonal() - trial.driving;
    }
    for (Eigen::Index i = 0; i < trial.x.cols(); ++i) {
        if (model.inverse_mass[i] == 0) {
            trial.driving.col(i).setZero();
            continue;
        }
        const Vec3 gained = trial.v.col(i) - stage.vp.col(i);
        trial.potential += 0.5 * model.mass[i] * gained.squaredNorm();
        trial.residual.col(i) = model.mass[i] * (trial.residual.col(i) - gained / stage.c);
    }
    return trial.residual.allFinite();
}

double StageSolver::rise(const Trial& from, const Trial& to) const {
    return to.potential - from.potential -
           0.5 * (from.driving + to.driving).cwiseProduct(to.x - from.x).sum();
}

// Starts where the vertices are, or where they would fly without forces if that is better.
bool StageSolver::start(const ImplicitStage& stage, const State& state) {
    State placed{state.x, state.v, stage.time};
    place_pins(dynamics_.model(), placed);
    pin_velocity_ = placed.v;
    Points flight = stage.xp + stage.c * stage.vp - placed.x;
    for (Eigen::Index i = 0; i < flight.cols(); ++i)
        if (dynamics_.model().inverse_mass[i] == 0) flight.col(i).setZero();
    double part = 1;
    if (Contact* contact = dynamics_.contact()) {
        contact->cover(placed.x, stage.time, largest_move(flight));
        part = contact->clear_part(placed.x, flight, stage.time);
    }
    now_.x = placed.x;
    if (!evaluate(stage, now_)) return false;
    next_.x = placed.x + part * flight;
    if (evaluate(stage, next_) && rise(now_, next_) < 0) std::swap(now_, next_);
    return true;
}

// Whether next_, reached along a direction, is enough of an improvement on now_.
bool StageSolver::is_better(const Points& direction, double length) const {
    const double slope = -now_.residual.cwiseProduct(direction).sum(), change = rise(now_, next_);
    if (change <= enough * length * slope) return true;
    // where rounding hides the descent, the slope there tells
    const double noise = 1e-10 * std::abs(now_.potential);
    return change <= noise && -next_.residual.cwiseProduct(direction).sum() <= -(1 - 2 * enough) * slope;
}

double StageSolver::clear_part(const ImplicitStage& stage, const Points& direction) {
    Contact* contact = dynamics_.contact();
    if (!contact) return 1;
    contact->cover(now_.x, stage.time, largest_move(direction));
    return contact->clear_part(now_.x, direction, stage.time);
}

void StageSolver::take(const ImplicitStage& stage, const Points& direction) {
    next_.x = now_.x + clear_part(stage, direction) * direction;
    if (evaluate(stage, next_)) std::swap(now_, next_);
}

bool StageSolver::search(const ImplicitStage& stage, const Points& direction, double& length) {
    const double move = largest_move(direction);
    length = clear_part(stage, direction);
    for (int halving = 0; halving < most_halvings; ++halving, length /= 2) {
        next_.x = now_.x + length * direction;
        bool possible = evaluate(stage, next_);
        for (int tried = 0; possible; ++tried) {
            if (is_better(direction, length)) {
                std::swap(now_, next_);
                return true;
            }
            possible = length == 1 && leap(stage, move, tried);
        }
    }
    return false;
}

double StageSolver::fine_move(const ImplicitStage& stage) const {
    return fine_length + fine_part * typical_move(stage);
}

double StageSolver::coarse_move(const ImplicitStage& stage) const {
    return coarse_length + coarse_part * typical_move(stage);
}

// Elastic forces only hold vertices back: none goes farther than it would freely. Short steps move a vertex
// by less than any length that matters, and yet what each leaves out adds up: for them the acceleration
// counts, as far as rounding of the positions lets it be known.
bool StageSolver::is_settled(const ImplicitStage& stage) const {
    const double left = largest_move(now_.residual * dynamics_.model().inverse_mass.asDiagonal());
    const double square = stage.c * stage.c, rounding = 4 * epsilon * now_.x.cwiseAbs().maxCoeff();
    return left * square < fine_move(stage) && left < std::max(fine_acceleration, rounding / square);
}

bool StageSolver::settle(const ImplicitStage& stage) {
    for (int i = 0; i < most_rounds(); ++i) {
        const Outcome outcome = improve(stage, i);
        if (outcome != Outcome::moved) return outcome == Outcome::converged;
    }
    return false;
}

// Where friction holds, the force jumps as cloth under load starts to creep: at standstill there is none. So
// it is taken a moment later, when the creep has set in.
void StageSolver::first_acceleration(const State& state, double h, Points& a) {
    dynamics_.acceleration(state.x, state.v, state.time, a);
    dynamics_.hold_friction();
    if (!dynamics_.friction().holds_any()) return;
    constexpr double moment = 0.01;  // of a step
    State soon = state;
    if (solve({state.x, state.v, moment * h, state.time + moment * h}, soon))
        a = acceleration_;
    else
        dynamics_.acceleration_with_friction(state.x, state.v, state.time, a);
}

bool StageSolver::solve(const ImplicitStage& stage, State& state) {
    begin(stage);
    if (!start(stage, state)) return false;
    for (int round = 0; round < most_friction_rounds; ++round) {
        const Points before = now_.x;
        if (!settle(stage)) return false;
        dynamics_.acceleration_with_friction(now_.x, now_.v, stage.time, scratch_);
        const bool held = dynamics_.friction().holds_any();
        const double moved = largest_move(now_.x - before);
        if (round > 0 && moved < coarse_move(stage)) break;
        if (round + 1 == most_friction_rounds) break;
        dynamics_.hold_friction();
        if (!held && !dynamics_.friction().holds_any()) break;
        if (!evaluate(stage, now_)) return false;
    }
    dynamics_.acceleration_with_friction(now_.x, now_.v, stage.time, scratch_);
    dynamics_.hold_friction();
    acceleration_ = (now_.v - stage.vp) / stage.c;
    state = {now_.x, now_.v, stage.time};
    return true;
}

}  // namespace drape
