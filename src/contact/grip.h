// A place where friction holds cloth, to an obstacle or to cloth.
#pragma once

#include "base/points.h"

namespace drape {

struct Grip {
    int vertex[4];     // columns of the State
    double weight[4];  // what slides is their weighted sum; between cloth and cloth the sum of weights is 0
    int corners;       // how many vertices
    Vec3 normal, surface_velocity;
    double most;  // mu times the normal force: what friction can hold [N]
};

}  // namespace drape
