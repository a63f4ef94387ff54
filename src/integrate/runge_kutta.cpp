#include "integrate/runge_kutta.h"

#include <algorithm>
#include <cmath>

namespace drape {

void RungeKutta4::start(Dynamics& dynamics, const State& state) {
    dynamics.acceleration(state.x, state.v, state.time, first_);
}

bool RungeKutta4::stage(Dynamics& dynamics, const State& state, double seconds, Points& a, double booked) {
    trial_.time = state.time + seconds;
    place_pins(dynamics.model(), trial_);
    dynamics.acceleration(trial_.x, trial_.v, trial_.time, a);
    if (dynamics.contact()) a += friction_;
    dynamics.book(booked);
    return !dynamics.touch().crossed;
}

bool RungeKutta4::advance(Dynamics& dynamics, State& state, double h) {
    dynamics.book(h / 6);
    const bool rubs = dynamics.contact() != nullptr;
    if (rubs) {
        ahead_ = state.v + h * first_;
        trial_.v = ahead_;
        dynamics.rub(trial_, h);
        friction_ = (trial_.v - ahead_) / h;
        first_ += friction_;
    }
    trial_.x = state.x + h / 2 * state.v;
    trial_.v = state.v + h / 2 * first_;
    if (!stage(dynamics, state, h / 2, second_, h / 3)) return false;
    trial_.x = state.x + h / 2 * state.v + h * h / 4 * first_;
    trial_.v = state.v + h / 2 * second_;
    if (!stage(dynamics, state, h / 2, third_, h / 3)) return false;
    trial_.x = state.x + h * state.v + h * h / 2 * second_;
    trial_.v = state.v + h * third_;
    if (!stage(dynamics, state, h, fourth_, h / 6)) return false;

    state.x += h * state.v + h * h / 6 * (first_ + second_ + third_);
    state.v += h / 6 * (first_ + 2 * (second_ + third_) + fourth_);
    state.time += h;
    place_pins(dynamics.model(), state);
    dynamics.acceleration(state.x, state.v, state.time, first_);
    if (rubs) fourth_ -= friction_;  // to be compared
    return !dynamics.touch().crossed;
}

double RungeKutta4::disagreement() const {
    return std::sqrt((fourth_ - first_).colwise().squaredNorm().maxCoeff());
}

double RungeKutta4::largest() const {
    return std::sqrt(
        std::max(third_.colwise().squaredNorm().maxCoeff(), first_.colwise().squaredNorm().maxCoeff()));
}

// A step multiplies a mode by R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24, z one of h times the two roots of
// s^2 + g s + w^2. |R(i y)|^2 = 1 - y^6/72 + y^8/576 passes 1 at y^2 = 8. With damping z is anywhere in the
// left half plane, no farther from 0 than h max(w, g): complex roots have size w, real ones at most g. |R| <=
// 1 holds on the left half disk of radius 2.6155, found by walking outwards along its rays.
double RungeKutta4::longest_step(const Spectrum& s) {
    if (s.gamma == 0) return std::sqrt(8.0) / s.omega;
    return 2.6155 / std::max(s.omega, s.gamma);
}

}  // namespace drape
