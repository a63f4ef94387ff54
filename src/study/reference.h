// What errors are measured against: a run far finer than any that is judged, and a second one made in
// another way. Where the two differ nothing can be said: their RMS distance, frame by frame, is the
// reference's error bar.
#pragma once

#include <string>
#include <vector>

#include "simulate/error_estimate.h"
#include "study/probe.h"

namespace drape {

struct Reference {
    std::string how;              // the first run
    bool checked = false;         // there is a second
    std::string checked_by;       // that one, or why there is none
    std::vector<Points> x;        // of the first, per frame
    State end;                    // of the first
    std::vector<ErrorNorms> bar;  // per frame, never 0 [m]
    double richardson = 0;  // what the first run's own coarser pass says about its error, last frame, RMS [m]
};

// Both runs together stay within `most_cpu` [s] as far as can be predicted; fine enough or not, there always
// is a first. setup.frames is the window.
Reference make_reference(const Setup& setup, const Probe& probe, double most_cpu);

}  // namespace drape
