// One pass through the scene, measured: what it cost, and its positions handed out frame by frame.
#pragma once

#include <functional>
#include <string>

#include "simulate/simulation.h"

namespace drape {

struct MeasuredPass {
    double step = 0;  // of a frame without contact [s]
    int frames = 0;   // that were finished
    long steps = 0, sweeps = 0;
    SolverWork solver;
    double cpu_seconds = 0, wall_seconds = 0;  // of advancing alone, without set-up [s]
    double energy_drift = 0;                   // end - start - driven + dissipated [J]
    State end;
    std::string trouble;     // "" = good
    bool cut_short = false;  // stopped because it cost more than was allowed
};

using AtFrame = std::function<void(const State&)>;

// Throws Error where the method refuses the scene. Stops after the frame in which the CPU time exceeds
// `most_cpu` [s].
MeasuredPass measure_pass(const Setup& setup, double most_cpu, const AtFrame& at_frame = {});

// `setup` stepped by `method` with `steps` equal steps a frame.
Setup with_steps(Setup setup, std::string_view method, int steps);

}  // namespace drape
