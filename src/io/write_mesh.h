// Meshes out: OBJ and PLY with UVs, in the mesh's file vertex order.
#pragma once

#include <string>

#include "mesh/mesh.h"

namespace drape {

// The text or bytes of the whole file; the ending of `path` chooses (.obj, .ply), else Error.
std::string mesh_file(const std::string& path, const Mesh& mesh, In positions);

void write_mesh(const std::string& path, const Mesh& mesh);

}  // namespace drape
