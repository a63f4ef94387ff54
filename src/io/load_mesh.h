// Loads a cloth mesh from any file assimp reads, guarded: whatever the file, a checked Mesh or one Error.
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace drape {

struct LoadedMesh {
    Mesh mesh;  // metres, y up, node transforms applied, welded, renumbered for locality
    // what loading found and did, for `inspect` and the report
    int dropped_zero_area = 0;   // triangles without rest area, left out
    int dropped_points_lines = 0;
    int unused_vertices = 0;     // vertices of the file that no triangle uses, kept out of the mesh
    std::vector<std::string> notes;  // "unit centimetre: scaled by 0.01", "z up: turned"
};

// Throws Error "FILE: what is wrong (what is allowed)".
LoadedMesh load_mesh(const std::string& path);

}  // namespace drape
