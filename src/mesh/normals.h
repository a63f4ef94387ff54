// Normals of triangle surfaces: smooth for cloth, creased at sharp edges for solids.
#pragma once

#include "base/points.h"

namespace drape {

// Unit normals at the vertices, each triangle weighed by sin(angle) / (product of the two sides there): exact
// for vertices on a sphere (Max 1999). A vertex without area around it gets the y axis.
Points vertex_normals(In x, const Faces& faces);

// A column per corner (3 f + c): the mean of the triangles around its vertex that turn from its own by less
// than `crease_deg`.
Points corner_normals(In x, const Faces& faces, double crease_deg);

}  // namespace drape
