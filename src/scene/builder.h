// A scene's description becomes a simulation: meshes loaded and placed, fabrics spun into springs, pins
// found.
#pragma once

#include <string>
#include <vector>

#include "scene/description.h"
#include "simulate/simulation.h"

namespace drape {

struct Built {
    Setup setup;
    std::vector<std::string> notes;  // what loading did to the files, a line each
    double load_seconds = 0;         // CPU, reading mesh files [s]
};

// Throws Error at the place in the scene file of whatever does not fit.
Built build_scene(const SceneDescription& scene);

// A cloth's pattern, with what an adaptive one learns from an earlier run's files.
PatternSize pattern_size_of(const SceneDescription& scene, const ClothDescription& cloth);

// The mesh that a cloth starts from, at rest in the world. Notes go to `notes`.
Mesh placed_mesh(const SceneDescription& scene, const ClothDescription& cloth,
                 std::vector<std::string>& notes);

}  // namespace drape
