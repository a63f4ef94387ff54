#include "base/wide.h"
#include "integrate/kinds.h"

namespace drape {

namespace {

// y += h x
DRAPE_WIDE void add_scaled(double* y, double h, const double* x, Eigen::Index values) {
    for (Eigen::Index i = 0; i < values; ++i) y[i] += h * x[i];
}

}  // namespace

void kick(Dynamics& dynamics, State& state, const Points& a, double h) {
    add_scaled(state.v.data(), h, a.data(), a.size());
    dynamics.rub_kicked(state, a, h);
}

void drift(Dynamics& dynamics, State& state, double h) {
    add_scaled(state.x.data(), h, state.v.data(), state.v.size());
    state.time += h;
    place_pins(dynamics.model(), state);
}

}  // namespace drape
