// Takahashi-Imada: Verlet whose acceleration is taken at x + h^2/12 a(x), two sweeps a step. The shift adds
// h^2/12 a'(x) a(x), the gradient of a potential, so the step stays symplectic and its leading error becomes
// a mere change of variables. Undoing that change (processing, Blanes and Moan's term) gives order four:
// steps run on
//   xh = x - h^2/12 a(x) + O(h^4),   vh = v + h^2/12 a'(x) v + O(h^4)
// and outputs apply the inverse. The change is made of kicks and drifts, so it is symplectic and its inverse
// exact: an inverse that is only nearly one pumps the fastest modes at every output. Only kick-drift-kick
// goes with this processor. The order is checked by tests/integrate/test_order.cpp.
//
// With damping, contact, friction or moving pins nothing is processed and the order is two: the shift uses
// the conservative forces, the second sweep all of them at the velocity that Verlet uses.
//
// Stability: a mode's (h w)^2 becomes A = (h w)^2 (1 - (h w)^2 / 12), which never passes 4 and stays positive
// up to h w / 2 = sqrt 3. With damping A + 4 h g <= 4 must hold for every mode: since A <= 3, h g <= 1/4 is
// enough.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "integrate/kinds.h"

namespace drape {

namespace {

class TakahashiImada final : public Integrator {
public:
    void begin(Dynamics& dynamics, State& state, double h) override {
        if (dynamics.is_conservative()) process(dynamics, state, h);
        shifted_acceleration(dynamics, state, state.v, h);
    }
    bool step(Dynamics& dynamics, State& state, double h) override {
        dynamics.book(h / 2);
        kick(dynamics, state, a_, h / 2);
        drift(dynamics, state, h);
        ahead_ = state.v + h / 2 * a_;
        shifted_acceleration(dynamics, state, ahead_, h);
        dynamics.book(h / 2);
        kick(dynamics, state, a_, h / 2);
        return true;
    }
    void end(Dynamics& dynamics, State& state, double h) override {
        if (dynamics.is_conservative()) unprocess(dynamics, state, h);
    }

private:
    void shifted_acceleration(Dynamics& dynamics, const State& state, const Points& v, double h) {
        dynamics.conservative_acceleration(state.x, state.time, a_);
        shifted_ = state.x + h * h / 12 * a_;
        if (dynamics.is_conservative())
            dynamics.conservative_acceleration(shifted_, state.time, a_);
        else
            dynamics.acceleration_to_kick(shifted_, v, state.time, a_);
    }

    // Drift s, kick s, drift -s, kick -s is x - s^2 a, v + s^2 a' v up to O(h^3); the same with s turned
    // cancels that order. Twice s^2 is h^2/12.
    void process(Dynamics& dynamics, State& state, double h) {
        const double s = h / std::sqrt(24.0);
        for (const double way : {s, -s}) {
            move(state, way);
            push(dynamics, state, way);
            move(state, -way);
            push(dynamics, state, -way);
        }
    }

    // the same moves backwards
    void unprocess(Dynamics& dynamics, State& state, double h) {
        const double s = h / std::sqrt(24.0);
        for (const double way : {-s, s}) {
            push(dynamics, state, way);
            move(state, way);
            push(dynamics, state, -way);
            move(state, -way);
        }
    }

    void move(State& state, double h) { state.x += h * state.v; }
    void push(Dynamics& dynamics, State& state, double h) {
        dynamics.conservative_acceleration(state.x, state.time, pushed_);
        state.v += h * pushed_;
    }

    Points a_, shifted_, ahead_, pushed_;
};

}  // namespace

std::unique_ptr<Integrator> make_takahashi_imada() {
    return std::make_unique<TakahashiImada>();
}

double takahashi_imada_longest_step(const Spectrum& s) {
    double h = 2 * std::numbers::sqrt3 / s.omega;
    if (s.gamma > 0) h = std::min(h, 0.25 / s.gamma);
    // strong damping: Verlet's own condition is the weaker demand there, since A <= (h w)^2
    return std::max(h, verlet_longest_step(s));
}

}  // namespace drape
