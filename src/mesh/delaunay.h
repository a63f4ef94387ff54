// Delaunay triangulation of points in the plane, by Qhull.
#pragma once

#include <Eigen/Core>

namespace drape {

// 3 x F vertex indices, counter-clockwise. No point lies inside a triangle's circumcircle; of four points on
// one circle either diagonal may come. Throws Error if the points do not span a plane or two of them are the
// same to rounding.
Eigen::Matrix3Xi delaunay(const Eigen::Matrix2Xd& points);

}  // namespace drape
