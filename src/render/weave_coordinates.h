// Where the threads run: each drawn vertex gets its place along warp and weft in metres.
#pragma once

#include "mesh/mesh.h"

namespace drape {

// The drawn mesh with `uv` in metres of cloth. UVs of the mesh are scaled by what a unit of u and of v
// measures on average at rest; a mesh without UVs is projected along the axis that each triangle faces most
// at rest (one axis for all if the cloth is nearly flat), and split where that axis changes.
DrawnMesh with_weave_coordinates(const Mesh& mesh);

// Per vertex of `faces` the distance at rest to the nearest border [m], measured straight to a border edge
// that is reached along the surface. A surface without border gets `far` everywhere.
Eigen::VectorXf border_distance(const Points& rest, const Faces& faces, float far = 1e3f);

}  // namespace drape
