// Lone triangles and a fabric to give them altitude springs.
#pragma once

#include <vector>

#include "support/cloths.h"
#include "support/meshes.h"

namespace drape::test {

// k = 1 N per strain in edges and altitudes alike.
Fabric altitude_fabric(AltitudeMode mode);

Mesh scalene_triangle();

// Triangles crushed onto their base, to an edge of no length, to a point.
std::vector<Points> collapsed_triangles();

}  // namespace drape::test
