#include "integrate/splitting.h"

#include "base/assert.h"
#include "integrate/kinds.h"

namespace drape {

namespace {

// The last kick's acceleration is the next step's first: a step costs a sweep per drift.
class SplittingIntegrator final : public Integrator {
public:
    explicit SplittingIntegrator(const Splitting& splitting) : splitting_(splitting) {}

    void begin(Dynamics& dynamics, State& state, double) override {
        DRAPE_ASSERT(dynamics.is_conservative());
        dynamics.conservative_acceleration(state.x, state.time, a_);
    }
    bool step(Dynamics& dynamics, State& state, double h) override {
        kick(dynamics, state, a_, splitting_.kicks[0] * h);
        for (size_t i = 0; i < splitting_.drifts.size(); ++i) {
            drift(dynamics, state, splitting_.drifts[i] * h);
            dynamics.conservative_acceleration(state.x, state.time, a_);
            kick(dynamics, state, a_, splitting_.kicks[i + 1] * h);
        }
        return true;
    }

private:
    Splitting splitting_;
    Points a_;
};

}  // namespace

std::unique_ptr<Integrator> make_splitting(const Splitting& splitting) {
    return std::make_unique<SplittingIntegrator>(splitting);
}

}  // namespace drape
