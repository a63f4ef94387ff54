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

// Cloth strained that far is that deep in an obstacle [m] at `time` [s].
std::string why_inside(double depth, double time, double strain);

// So many steps, the last of `step` [s], have come no farther than `state`.
std::string why_no_end(const Dynamics& dynamics, const State& state, long steps, double step);

// No step from `time` on, however short, was possible.
std::string why_no_step(const Dynamics& dynamics, double time);

}  // namespace drape
