// The classical Runge-Kutta step with its free estimate of order three (runge_kutta.h), cut into shorter
// inner steps where the estimate says that the motion is not resolved. Among the usual embedded pairs it
// suits cloth best, whose modes vibrate and set the step by stability: per sweep it reaches h w = 0.71,
// Bogacki-Shampine 3(2) 0.58, Dormand-Prince 5(4) 0.17.
//
// An inner step k <= h is accepted when the two values of the acceleration at its end agree,
//   |a4 - a5| <= tolerance |a| min(h / k, loosest)          (largest of any vertex on both sides).
// The left side times k / 6 is the local error in velocity; the factor h / k shares what is allowed evenly
// over time, less of it where h is shorter. The tolerance is a share of the motion's own acceleration, so no
// length or time need be known. Once h resolves the motion nothing is cut, and in h the order is four. Of a
// vibration that is all there is the left side is (k w)^3 / 12: with the numbers below uncut steps have k w <
// 0.84, and however long h is, k w < 1.06.
#include <algorithm>
#include <cmath>

#include "integrate/kinds.h"
#include "integrate/runge_kutta.h"

namespace drape {

namespace {

constexpr double tolerance = 0.05;
constexpr double loosest = 2;
constexpr double rest = 1e-4;               // accelerations below it need no resolving [m/s^2]
constexpr double caution = 0.9;             // of the inner step that would just be accepted
constexpr double least = 0.2, most = 2;     // change of the inner step from one to the next
constexpr double shortest_share = 0x1p-30;  // of h: shorter inner steps mean that nothing helps

class EmbeddedRk final : public Integrator {
public:
    void begin(Dynamics& dynamics, State& state, double h) override {
        inner_ = h;
        rule_.start(dynamics, state);
    }
    bool step(Dynamics& dynamics, State& state, double h) override {
        const double end = state.time + h;
        for (double left = h; left > 1e-12 * h; left = end - state.time) {
            const double k = left / std::ceil(left / std::min(inner_, h) * (1 - 1e-12));
            before_ = state;
            const EnergyFlow flow = dynamics.flow();
            const bool inside = rule_.advance(dynamics, state, k);
            const double found = inside ? rule_.disagreement() : INFINITY;
            const double allowed = tolerance * std::max(rule_.largest(), rest) * std::min(h / k, loosest);
            inner_ = k * change(found, allowed);
            if (found <= allowed) continue;
            if (!(inner_ > shortest_share * h)) return false;
            state = before_;
            dynamics.reset_flow(flow);
            rule_.start(dynamics, state);
        }
        state.time = end;
        return true;
    }

private:
    static double change(double found, double allowed) {
        if (found == 0) return most;
        if (!(found < INFINITY)) return least;
        return std::clamp(caution * std::cbrt(allowed / found), least, most);
    }

    RungeKutta4 rule_;
    State before_;
    double inner_ = 0;  // the next inner step to try [s]
};

}  // namespace

std::unique_ptr<Integrator> make_embedded_rk() {
    return std::make_unique<EmbeddedRk>();
}

double embedded_rk_longest_step(const Spectrum& s) {
    return RungeKutta4::longest_step(s);
}

}  // namespace drape
