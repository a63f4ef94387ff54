// Small meshes that tests share.
#pragma once

#include <initializer_list>
#include <string>

#include "base/error.h"
#include "mesh/mesh.h"

namespace drape {

Points points_of(std::initializer_list<Vec3> list);

Faces faces_of(std::initializer_list<Eigen::Vector3i> list);

// A unit square in the x-y plane, cut along the diagonal from vertex 0 to vertex 2.
Mesh two_triangles();

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
