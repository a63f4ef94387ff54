// How much memory a run will take, before anything of it is built.
#pragma once

#include <cstdint>

#include "scene/description.h"

namespace drape {

struct RunExtent {
    int frames = 0;          // that are delivered
    bool two_passes = true;  // the error is estimated, or a tolerance met
    int drawing = 0;         // threads that draw
};

// From bytes per vertex that peaks of runs by Verlet came to; a factor of an implicit step comes on top.
// Cloths from mesh files count as nothing: their files are read within limits of their own. [bytes]
double predicted_memory(const SceneDescription& scene, const RunExtent& extent);

// What this process may still take, of the machine and of its limits. [bytes]
double free_memory();

}  // namespace drape
