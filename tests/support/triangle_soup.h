// Slow and plain measures of a triangle mesh, against which the fast ones are held.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/mesh.h"

namespace drape::test {

inline double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (a + t * (b - a) - p).norm();
}

inline double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = (b - a).cross(c - a);
    const bool above = n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 &&
                       n.dot((a - c).cross(p - c)) >= 0;
    if (above) return std::abs(n.dot(p - a)) / n.norm();
    return std::min(
        {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

inline double distance_to_triangles(const Mesh& mesh, const Vec3& p) {
    double least = INFINITY;
    for (int f = 0; f < mesh.triangles(); ++f) {
        const Eigen::Vector3i v = mesh.faces.col(f);
        least = std::min(
            least, distance_to_triangle(p, mesh.rest.col(v[0]), mesh.rest.col(v[1]), mesh.rest.col(v[2])));
    }
    return least;
}

// How often a closed mesh goes round p: 1 inside, 0 outside. Solid angles by van Oosterom and Strackee.
inline double winding_number(const Mesh& mesh, const Vec3& p) {
    double sum = 0;
    for (int f = 0; f < mesh.triangles(); ++f) {
        const Vec3 a = mesh.rest.col(mesh.faces(0, f)) - p, b = mesh.rest.col(mesh.faces(1, f)) - p,
                   c = mesh.rest.col(mesh.faces(2, f)) - p;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        sum +=
            2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return sum / (4 * std::numbers::pi);
}

}  // namespace drape::test
