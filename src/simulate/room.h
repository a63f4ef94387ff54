// Where a scene will play: what an automatic camera frames and shadows are fitted to.
#pragma once

#include "simulate/simulation.h"

namespace drape {

// The box that cloths, pins and obstacles will take up, as far as can be said before anything has moved:
// where they start; where pins and obstacles are carried; how far held cloth can hang down from its nearest
// pin; the ground that loose cloth falls to. Obstacles without end, planes, count only as ground.
Eigen::AlignedBox3d room_of(const Simulation& simulation);

}  // namespace drape
