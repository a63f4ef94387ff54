// The key light and the map of what it sees.
#pragma once

#include "render/camera.h"

namespace drape {

struct Light {
    Vec3 to_light;                // unit
    Vec3 right, up;               // unit axes of the map
    Eigen::Matrix4f to_map;       // world to [0, 1]^3
    double width = 0, range = 0;  // of the map across and in depth [m]
};

// The light stands to the left of the camera and above; the map covers the sphere. Casters outside the map's
// depth still count (their depth is clamped).
Light place_light(const View& view, const Vec3& centre, double radius);

}  // namespace drape
