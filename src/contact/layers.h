// How two surfaces that meet press and rub on each other.
#pragma once

#include <vector>

#include "cloth/state.h"
#include "contact/barrier.h"
#include "contact/surfaces.h"

namespace drape {

struct Layers {       // two surfaces, or one with itself
    Barrier barrier;  // its thickness is negative where they do not meet
    double density;   // of both together, as far as their relative motion goes [kg/m^2]
    double friction;  // [-]
};

// Number of two surfaces' Layers.
inline int layers_of(int surface, int other, int surfaces) {
    return surface < other ? surface * surfaces + other : other * surfaces + surface;
}

// By layers_of. `model`: the cloths; `start` and `duration` tell how fast they may meet anything.
std::vector<Layers> layers_between(const Surfaces& surfaces, const Model& model, const Vec3& gravity,
                                   const State& start, double duration);

// How fast a cloth may hit an obstacle: by falling from where it starts, and by the obstacle's own motion
// [m/s].
double impact_speed(const Cloth& cloth, const Obstacle& obstacle, const Vec3& gravity, const State& start,
                    double duration);

}  // namespace drape
