#include "support/meshes.h"

namespace drape {

Points points_of(std::initializer_list<Vec3> list) {
    Points points(3, static_cast<Eigen::Index>(list.size()));
    Eigen::Index column = 0;
    for (const Vec3& point : list) points.col(column++) = point;
    return points;
}

Faces faces_of(std::initializer_list<Eigen::Vector3i> list) {
    Faces faces(3, static_cast<Eigen::Index>(list.size()));
    Eigen::Index column = 0;
    for (const Eigen::Vector3i& face : list) faces.col(column++) = face;
    return faces;
}

Mesh two_triangles() {
    return plain_mesh(points_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
                      faces_of({{0, 1, 2}, {0, 2, 3}}));
}

}  // namespace drape
