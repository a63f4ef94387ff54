// Loads a cloth mesh from any file assimp reads, guarded: whatever the file, a checked Mesh or one Error.
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace drape {

struct LoadedMesh {
    Mesh mesh;  // metres, y up, node transforms applied, welded, renumbered for locality
    // what loading found and did, for `inspect` and the report
    int dropped_zero_area = 0;  // triangles without rest area, left out
    int dropped_points_lines = 0;
    int unused_vertices = 0;         // vertices of the file that no triangle uses, not simulated
    std::vector<std::string> notes;  // "unit 1 cm: scaled by 0.01", "up is z: turned to y up"
};

// The file's vertices, whose order Mesh::file_vertex keeps: the `v` lines of an OBJ, the vertex elements of a
// PLY, the position accessors of a glTF node after node; of other formats, which assimp unrolls into corners,
// the distinct places of each node in the order its faces use them. Files without units are in metres. Throws
// Error "FILE: what is wrong (what is allowed)", with "FILE:LINE:" where a text file has a line to blame.
LoadedMesh load_mesh(const std::string& path);

struct LoadedPositions {
    Points x;  // a column per vertex of the file, in its order [m]
    std::vector<std::string> notes;
};

// Where the file's vertices stand, as a pose of a mesh of another file: triangles need no area, and vertices
// may stand on one place (in formats that assimp unrolls those are one).
LoadedPositions load_positions(const std::string& path);

}  // namespace drape
