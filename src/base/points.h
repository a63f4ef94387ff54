// The words every layer speaks: a point, many points, triangles.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace drape {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

// A column per vertex; in memory x0 y0 z0 x1 ..., which is a solver's flat vector and a vertex buffer at
// once.
using Points = Eigen::Matrix3Xd;
using In = const Eigen::Ref<const Points>&;  // read
using Out = Eigen::Ref<Points>;              // added to

// A column per triangle: three vertex indices, counter-clockwise seen from the front.
using Faces = Eigen::Matrix3Xi;

}  // namespace drape
