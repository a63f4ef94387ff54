// Where a cloth comes to rest.
#pragma once

#include "cloth/model.h"

namespace drape {

struct Equilibrium {
    Points x;
    long iterations = 0;  // of Newton's method
    double moved = 0;     // what the last second of motion still moved any vertex [m]
    bool found = false;
};

// From `start` under gravity [m/s^2]: steps of backward Euler, which damps all that is faster than the step,
// each longer than the one before, until a second of them moves no vertex by over `still` [m].
Equilibrium come_to_rest(const Model& model, const Vec3& gravity, Points start, double still = 1e-7);

}  // namespace drape
