// What to tell of a frame that could not be made: when, at which vertex, under which force, and why it is
// likely so.
#pragma once

#include <string>

#include "integrate/dynamics.h"

namespace drape {

struct StepTaken {
    double step = 0, longest = 0;  // that was taken; that is stable [s]
};

// `state` is as the run left it: not finite, or with more energy than there was to have.
std::string why_it_ran_away(const Dynamics& dynamics, const State& state, const StepTaken& taken);

// No step from `time` on, however short, was possible.
std::string why_no_step(const Dynamics& dynamics, double time);

}  // namespace drape
