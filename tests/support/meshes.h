// Small meshes that tests share.
#pragma once

#include <initializer_list>
#include <string>

#include "base/error.h"
#include "mesh/mesh.h"

namespace drape {

inline Points points_of(std::initializer_list<Vec3> list) {
    Points points(3, static_cast<Eigen::Index>(list.size()));
    Eigen::Index column = 0;
    for (const Vec3& point : list) points.col(column++) = point;
    return points;
}

inline Faces faces_of(std::initializer_list<Eigen::Vector3i> list) {
    Faces faces(3, static_cast<Eigen::Index>(list.size()));
    Eigen::Index column = 0;
    for (const Eigen::Vector3i& face : list) faces.col(column++) = face;
    return faces;
}

// A unit square in the x-y plane, cut along the diagonal from vertex 0 to vertex 2.
inline Mesh two_triangles() {
    return plain_mesh(points_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
                      faces_of({{0, 1, 2}, {0, 2, 3}}));
}

// What an Error says; "" if `work` throws none.
template <class Work>
std::string error_of(Work&& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace drape
