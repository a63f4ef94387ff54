#include "integrate/kinds.h"

namespace drape {

void kick(Dynamics& dynamics, State& state, const Points& a, double h) {
    state.v += h * a;
    dynamics.rub(state, h);
}

void drift(Dynamics& dynamics, State& state, double h) {
    state.x += h * state.v;
    state.time += h;
    place_pins(dynamics.model(), state);
}

}  // namespace drape
