// The other error: what the mesh itself costs in accuracy. The same sheet of the same fabric at half, once
// and twice the divisions, compared where all have a vertex.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/description.h"
#include "simulate/error_estimate.h"

namespace drape {

struct RefinedMesh {
    double factor = 1;  // of the scene's divisions
    int vertices = 0;
    double cpu_seconds = 0;
    ErrorNorms last;       // distance from the finest at the last frame [m]
    double worst_rms = 0;  // of any frame [m]
    std::string left_out;  // why; "" = it was run
};

struct MeshRefinement {
    std::string refused;  // why there is none; "" = there is
    std::vector<RefinedMesh>
        meshes;  // the coarsest first; the last that was run is what the others are judged by
    std::optional<double> error;  // of the scene's own mesh at the last frame, RMS, estimated [m]
    double order = 2;             // in the edge length, which the estimate rests on
    bool order_seen = false;      // by three meshes; else assumed
    bool converges =
        true;          // false: finer meshes come no nearer to each other, and the error is at least that
    std::string note;  // what stands against comparing these meshes; "" = nothing
};

MeshRefinement refine_mesh(const SceneDescription& scene, int frames, double most_cpu,
                           const std::function<void(const std::string&)>& say);

}  // namespace drape
