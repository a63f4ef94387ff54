// A mesh anew: what its boundary encloses, filled with a pattern.
#pragma once

#include "mesh/pattern.h"

namespace drape {

// A flat mesh is filled in its plane; a curved one in the plane of its UVs, which must have no seam and
// stretch it by two at most, and laid onto its triangles again. `size` says all but width and depth; its
// divisions are those of the bounding box, 0 x 0 for edges as long as the mesh's mean one. UVs are carried
// over. In the plane x is x and y is z where the mesh is level, else they are axes of its plane or u and -v
// in metres. Throws Error for a mesh of several pieces, without boundary, that overlaps itself, or is curved
// without such UVs.
Mesh remesh(const Mesh& mesh, std::string_view pattern, PatternSize size);

}  // namespace drape
