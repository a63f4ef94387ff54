// Where cloth truly goes, as far as can be found out without the methods that are checked: by SUNDIALS, or
// where there is contact by a far finer run of the classical Runge-Kutta method.
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

// `most_cpu` [s] for SUNDIALS.
TruePositions true_positions(const Setup& setup, double most_cpu);

}  // namespace drape::bench
