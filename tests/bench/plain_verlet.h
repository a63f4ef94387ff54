// The loop to beat: velocity Verlet over a list of springs, scalar, one thread.
#pragma once

#include "bench/contestant.h"
#include "bench/spring_system.h"

namespace drape::bench {

// Positions after `time` [s] in `steps` equal steps.
Points run_plain_verlet(const SpringSystem& system, double time, int steps);

// Its ladder, from `fewest` steps on.
Contestant plain_verlet(const SpringSystem& system, double time, double fewest);

}  // namespace drape::bench
