// drape itself: every method that suits at fixed steps, and deliveries as a user gets them.
#pragma once

#include "bench/contestant.h"
#include "simulate/simulation.h"

namespace drape::bench {

// `setup` is one frame to the final time.
std::vector<Contestant> fixed_settings(const Setup& setup);

// A run to the tolerance [m], its frames those of `setup`, with the error it states.
Contestant to_tolerance(const Setup& setup, double tolerance);

// xpbd at fixed steps with a second pass beside it, and the error that these state; for the error `only_for`
// [m].
Contestant projections_with_error(const Setup& setup, double only_for);

// A run that asks for nothing, with the error it states.
Contestant nothing_asked(const Setup& setup);

}  // namespace drape::bench
