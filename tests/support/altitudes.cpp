#include "support/altitudes.h"

namespace drape::test {

Fabric altitude_fabric(AltitudeMode mode) {
    Fabric fabric = bare_springs(1);
    fabric.stretch_model = StretchModel::force_per_strain;
    fabric.altitude = mode;
    return fabric;
}

Mesh scalene_triangle() {
    return plain_mesh(points_of({{0, 0, 0}, {0.3, 0.2, 0.7}, {1, 0.1, 0}}), faces_of({{0, 1, 2}}));
}

std::vector<Points> collapsed_triangles() {
    return {points_of({{0, 0, 0}, {0.3, 0, 0}, {1, 0, 0}}), points_of({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}),
            points_of({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}})};
}

}  // namespace drape::test
