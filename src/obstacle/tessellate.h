// Surfaces of solids as triangles, for drawing.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace drape {

struct ProfilePoint {
    double radius, height;  // from the axis, along the axis [m]
};

// Turns a profile about `axis` through `centre`. Walking the profile, outward is to the right of (radius,
// height): a rod is drawn from its bottom (0, -h) over its side to its top (0, h). `closed` joins the ends.
Mesh revolve(const std::vector<ProfilePoint>& profile, bool closed, const Vec3& centre, const Vec3& axis,
             int segments = 96);

// A box with edges rounded by `rounding`, in its own frame.
Mesh rounded_box(const Vec3& half, double rounding);

// Merges vertices closer than about 1e-7 m and drops triangles that lose a corner by it.
Mesh merge_close(const Points& points, const std::vector<Eigen::Vector3i>& faces);

}  // namespace drape
