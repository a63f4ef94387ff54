// assimp's part of loading: a file becomes triangles in metres, y up. The only place that knows assimp.
#pragma once

#include <string>
#include <vector>

#include "mesh/weld.h"

namespace drape {

// A vertex whose colour is (m % mark_base, m / mark_base, 0) has mark m: exact in single precision up to
// 2^32.
constexpr int mark_base = 65536;

struct ImportedScene {
    TriangleSoup soup;               // all meshes at all their nodes, node transforms applied
    std::vector<int> mark;           // of each vertex, if the file's vertices have colours; else empty
    int points_lines = 0;            // points and lines left out
    std::vector<std::string> notes;  // how units and axes were taken
};

// Throws Error "FILE: what is wrong".
// PLY and glTF keep their vertices in order; of other formats assimp makes a vertex per corner, and the
// distinct places in order of first use stand for the file's vertices.
ImportedScene import_file(const std::string& path);

// An OBJ held in memory; vertices as assimp makes them. `path` is for messages.
ImportedScene import_obj(const std::string& path, const std::string& text);

}  // namespace drape
