// Every way in which SUNDIALS is tried: a new one is its function and its row in sundials_contestants.cpp.
#pragma once

#include "bench/contestant.h"
#include "bench/spring_system.h"

namespace drape::bench {

// Positions after `time` [s]; the tolerance is relative, and absolute in m and m/s. Gives up after `most_cpu`
// [s].
using SundialsRun = Outcome(const SpringSystem& system, double time, double tolerance, double most_cpu);

// Explicit pairs of ARKODE's ERKStep.
SundialsRun run_bogacki_shampine, run_dormand_prince, run_fehlberg_8;

// CVODE: Adams with functional iteration; BDF with Newton's, its systems solved directly on the exact sparse
// Jacobian (KLU), or by GMRES on exact Jacobian-vector products.
SundialsRun run_adams, run_bdf_direct, run_bdf_krylov;

// All of them, laddered over tolerances. `system` must outlive them.
std::vector<Contestant> sundials_contestants(const SpringSystem& system, double time);

}  // namespace drape::bench
