// A regular pattern inside an outline: whole cells of it as far as they fit, and a seam of Delaunay triangles
// between them and points that stand evenly on the outline.
#pragma once

#include "mesh/mesh.h"
#include "mesh/outline.h"

namespace drape {

// `grid` is the pattern over the outline's bounding box, in which every `cell` triangles one after the other
// make a cell; `edge` [m] is how far apart points stand on the outline. Throws Error where that is too far.
Mesh cut_pattern(const Mesh& grid, int cell, const Outline& outline, double edge);

}  // namespace drape
