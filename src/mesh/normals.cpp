#include "mesh/normals.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace drape {

namespace {

// For each corner the triangle's normal with the corner's weight; zero where it has no area.
std::array<Vec3, 3> weighed_normals(In x, const Eigen::Vector3i& corner) {
    const Vec3 side[3] = {x.col(corner[1]) - x.col(corner[0]), x.col(corner[2]) - x.col(corner[1]),
                          x.col(corner[0]) - x.col(corner[2])};
    const Vec3 area = side[0].cross(-side[2]);
    const double length2[3] = {side[0].squaredNorm(), side[1].squaredNorm(), side[2].squaredNorm()};
    std::array<Vec3, 3> normals;
    for (size_t c = 0; c < 3; ++c) {
        const double product = length2[c] * length2[(c + 2) % 3];
        normals[c] = product > 0 ? Vec3(area / product) : Vec3::Zero();
    }
    return normals;
}

Vec3 unit_or_up(const Vec3& v) {
    const double length = v.norm();
    return length > 0 ? Vec3(v / length) : Vec3::UnitY();
}

}  // namespace

Points vertex_normals(In x, const Faces& faces) {
    Points normals = Points::Zero(3, x.cols());
    for (int f = 0; f < faces.cols(); ++f) {
        const auto weighed = weighed_normals(x, faces.col(f));
        for (int c = 0; c < 3; ++c) normals.col(faces(c, f)) += weighed[static_cast<size_t>(c)];
    }
    for (int v = 0; v < normals.cols(); ++v) normals.col(v) = unit_or_up(normals.col(v));
    return normals;
}

Points corner_normals(In x, const Faces& faces, double crease_deg) {
    const double least = std::cos(crease_deg * std::numbers::pi / 180);
    std::vector<std::vector<int>> corners_at(static_cast<size_t>(x.cols()));
    Points weighed(3, faces.size()), flat(3, faces.cols());
    for (int f = 0; f < faces.cols(); ++f) {
        const auto normal = weighed_normals(x, faces.col(f));
        for (int c = 0; c < 3; ++c) {
            corners_at[static_cast<size_t>(faces(c, f))].push_back(3 * f + c);
            weighed.col(3 * f + c) = normal[static_cast<size_t>(c)];
        }
        flat.col(f) = unit_or_up(normal[0] + normal[1] + normal[2]);
    }
    Points normals = Points::Zero(3, faces.size());
    for (int f = 0; f < faces.cols(); ++f)
        for (int c = 0; c < 3; ++c) {
            for (const int other : corners_at[static_cast<size_t>(faces(c, f))])
                if (flat.col(f).dot(flat.col(other / 3)) >= least)
                    normals.col(3 * f + c) += weighed.col(other);
            normals.col(3 * f + c) = unit_or_up(normals.col(3 * f + c));
        }
    return normals;
}

}  // namespace drape
