// How a triangle mesh is bent.
#pragma once

#include <vector>

#include "mesh/topology.h"

namespace drape {

// Around every vertex, the curvature measure of Cohen-Steiner and Morvan (Restricted Delaunay Triangulations
// and Normal Cycle, 2003) over a third of its triangles' area,
//   T = 1 / (2 A) sum theta l e e^T   over its edges,
// theta the angle between the two triangles of an edge in pose `x`, positive on a ridge seen from the front,
// l and e its length and direction at `rest`. A fold of curvature k has the eigenvalue k, along the fold
// [1/m].
std::vector<Mat3> curvature_tensors(const Topology& topology, const Faces& faces, In rest, In x);

// The largest of a tensor's curvatures, whatever its sign [1/m].
double sharpest(const Mat3& tensor);

}  // namespace drape
