// A camera as matrices, for drawing and for asking what it sees.
#pragma once

#include "render/picture.h"

namespace drape {

struct View {
    Eigen::Matrix4f to_clip;       // world to clip space
    Vec3 eye, right, up, forward;  // unit axes
    double tan_x = 0, tan_y = 0;   // half the picture at distance 1
    double near = 0, far = 0;      // [m]

    // Throws Error if the camera stands where it looks or its angle is not in (0, 170) degrees.
    View(const Camera& camera, double aspect);
    // Extends `seen` by where the points appear, in [-1, 1]^2 over the picture; by all of it for a point
    // behind the eye or not finite.
    void project(const Points& points, Eigen::AlignedBox2d& seen) const;
    // no point of the sphere is in the picture
    bool misses(const Vec3& centre, double radius) const;
};

// A rectangle of pixels, rows from the bottom.
struct PixelBox {
    int x = 0, y = 0, width = 0, height = 0;
};

// The pixels of `seen` and one more on each side, within the picture.
PixelBox pixels_around(const Eigen::AlignedBox2d& seen, int width, int height);

}  // namespace drape
