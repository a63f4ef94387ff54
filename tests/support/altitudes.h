// Lone triangles and a fabric to give them altitude springs.
#pragma once

#include <vector>

#include "support/cloths.h"
#include "support/meshes.h"

namespace drape::test {

// k = 1 N per strain in edges and altitudes alike.
inline Fabric altitude_fabric(AltitudeMode mode) {
    Fabric fabric = bare_springs(1);
    fabric.stretch_model = StretchModel::force_per_strain;
    fabric.altitude = mode;
    return fabric;
}

inline Mesh scalene_triangle() {
    return plain_mesh(points_of({{0, 0, 0}, {0.3, 0.2, 0.7}, {1, 0.1, 0}}), faces_of({{0, 1, 2}}));
}

// Triangles crushed onto their base, to an edge of no length, to a point.
inline std::vector<Points> collapsed_triangles() {
    return {points_of({{0, 0, 0}, {0.3, 0, 0}, {1, 0, 0}}), points_of({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}),
            points_of({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}})};
}

}  // namespace drape::test
