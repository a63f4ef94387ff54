// All that moves. Copies by =: snapshot, rollback, twin run.
#pragma once

#include "base/points.h"

namespace drape {

struct State {
    Points x;         // positions [m], all cloths one after the other
    Points v;         // velocities [m/s]
    double time = 0;  // [s]
};

}  // namespace drape
