// Where cloth truly goes, as far as can be found out without the methods that are checked: by SUNDIALS, or by
// ever finer runs of the classical Runge-Kutta method where there is contact, or a force that jumps.
#pragma once

#include <string>
#include <vector>

#include "simulate/simulation.h"

namespace drape::bench {

struct TruePositions {
    std::vector<Points> x;  // per frame
    std::vector<double>
        bar;  // per frame, the distance of a second run, coarser or of another method, RMS [m]
    std::string how;
};

// The bar is to be `wanted` [m] at most in the first `frames` frames, as far as some minutes pay for it.
TruePositions true_positions(const Setup& setup, size_t frames, double wanted);

}  // namespace drape::bench
