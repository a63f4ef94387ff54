// BDF2: x and v at the end from the two states before, with r the step over the one before:
//   x2 = (1 + r)^2 / (1 + 2 r) x1 - r^2 / (1 + 2 r) x0 + (1 + r) / (1 + 2 r) h v2,   and the same for v with
//   a
// Order two, one solve a step; L-stable for equal steps, and for steps that grow by less than 1 + sqrt 2. The
// first step, and one after a shorter one by more than half, is of TR-BDF2, which needs no state before and
// is of order two as well.
#include "integrate/kinds.h"
#include "integrate/staged_integrator.h"

namespace drape {

namespace {

class Bdf2 final : public StagedIntegrator {
public:
    void begin(Dynamics& dynamics, State& state, double h) override {
        solver(dynamics).first_acceleration(state, h, a_);
        last_step_ = 0;
    }
    bool step(Dynamics& dynamics, State& state, double h) override {
        const State start = state;
        if (h > most_growth * last_step_) {
            if (!tr_bdf2_step(dynamics, solver(dynamics), state, a_, h)) return false;
        } else {
            const double r = h / last_step_, whole = 1 + 2 * r;
            const double near = (1 + r) * (1 + r) / whole, far = r * r / whole;
            dynamics.book(h / 2);
            if (!solver(dynamics).solve({near * start.x - far * before_.x, near * start.v - far * before_.v,
                                         (1 + r) / whole * h, start.time + h},
                                        state))
                return false;
            dynamics.book(h / 2);
            a_ = solver(dynamics).acceleration();
        }
        before_ = start;
        last_step_ = h;
        return true;
    }

private:
    static constexpr double most_growth = 2;
    State before_;
    Points a_;
    double last_step_ = 0;  // 0: there is no state before
};

}  // namespace

std::unique_ptr<Integrator> make_bdf2() {
    return std::make_unique<Bdf2>();
}

}  // namespace drape
