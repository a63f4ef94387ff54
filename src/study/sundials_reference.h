// The referee from outside: the scene as a first-order differential equation for SUNDIALS' explicit
// Runge-Kutta pair of order 8(7) (Fehlberg's, 13 stages; ARKODE's ERKStep). Nothing but the forces is shared
// with drape's own methods.
//   y = (x, v) of the free vertices,  y' = (v, a(x, v, t)),  pins placed at every time asked for
#pragma once

#include <string>
#include <vector>

#include "simulate/simulation.h"

namespace drape {

struct SundialsRun {
    std::vector<Points> x;  // per frame; empty where it was too dear or failed
    std::string how;        // with its tolerances, or why there is none
};

// At the tightest tolerances that `most_cpu` [s] pay for.
SundialsRun run_sundials(const Setup& setup, double most_cpu);

std::string sundials_version();

}  // namespace drape
