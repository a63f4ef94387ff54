#include "obstacle/tessellate.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "base/rigid_motion.h"

namespace drape {

Mesh merge_close(const Points& points, const std::vector<Eigen::Vector3i>& faces) {
    std::map<std::array<long long, 3>, int> seen;
    std::vector<int> merged(static_cast<size_t>(points.cols()));
    Points kept(3, points.cols());
    int count = 0;
    for (int i = 0; i < points.cols(); ++i) {
        std::array<long long, 3> cell{};
        for (int c = 0; c < 3; ++c) cell[static_cast<size_t>(c)] = std::llround(points(c, i) * 1e7);
        const auto [entry, fresh] = seen.try_emplace(cell, count);
        if (fresh) kept.col(count++) = points.col(i);
        merged[static_cast<size_t>(i)] = entry->second;
    }
    Faces kept_faces(3, static_cast<Eigen::Index>(faces.size()));
    int f = 0;
    for (const Eigen::Vector3i& face : faces) {
        const Eigen::Vector3i corner = face.unaryExpr([&](int v) { return merged[static_cast<size_t>(v)]; });
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
        kept_faces.col(f++) = corner;
    }
    return plain_mesh(kept.leftCols(count), kept_faces.leftCols(f));
}

Mesh revolve(const std::vector<ProfilePoint>& profile, bool closed, const Vec3& centre, const Vec3& axis,
             int segments) {
    const Mat3 turn = rotation_from_up(axis);
    const int rings = static_cast<int>(profile.size());
    Points points(3, rings * segments);
    for (int s = 0; s < segments; ++s) {
        const double angle = 2 * std::numbers::pi * s / segments;
        for (int r = 0; r < rings; ++r) {
            const auto [radius, height] = profile[static_cast<size_t>(r)];
            points.col(s * rings + r) =
                centre + turn * Vec3(radius * std::cos(angle), height, -radius * std::sin(angle));
        }
    }
    std::vector<Eigen::Vector3i> faces;
    for (int s = 0; s < segments; ++s) {
        const int here = s * rings, next = (s + 1) % segments * rings;
        for (int r = 0; r + 1 < rings + (closed ? 1 : 0); ++r) {
            const int up = (r + 1) % rings;
            faces.emplace_back(here + r, next + r, next + up);
            faces.emplace_back(here + r, next + up, here + up);
        }
    }
    return merge_close(points, faces);
}

Mesh rounded_box(const Vec3& half, double rounding) {
    // along each side of a cube: the arc of one edge, the flat between (-0 to +0), the arc of the other
    std::vector<double> steps;
    const int arc = rounding > 0 ? 6 : 0;
    for (int i = -arc; i <= 0; ++i) steps.push_back(i == 0 ? -0.0 : double(i) / arc);
    for (int i = 0; i <= arc; ++i) steps.push_back(i == 0 ? 0.0 : double(i) / arc);
    const int n = static_cast<int>(steps.size());
    const Vec3 inner = half - Vec3::Constant(rounding);

    std::vector<Vec3> points;
    std::vector<Eigen::Vector3i> faces;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const int first = static_cast<int>(points.size());
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            for (const double b : steps) {
                for (const double a : steps) {
                    Vec3 direction;
                    direction[axis] = side;
                    direction[u] = std::tan(a * std::numbers::pi / 4);
                    direction[v] = std::tan(b * std::numbers::pi / 4);
                    const Vec3 sign(std::copysign(1, direction[0]), std::copysign(1, direction[1]),
                                    std::copysign(1, direction[2]));
                    points.push_back(sign.cwiseProduct(inner) + rounding * direction.normalized());
                }
            }
            for (int j = 0; j + 1 < n; ++j) {
                for (int i = 0; i + 1 < n; ++i) {
                    const int p = first + j * n + i, q = p + 1, r = q + n, s = p + n;
                    const bool front = side > 0;
                    faces.emplace_back(p, front ? q : s, r);
                    faces.emplace_back(p, r, front ? s : q);
                }
            }
        }
    }
    Points columns(3, static_cast<Eigen::Index>(points.size()));
    for (size_t i = 0; i < points.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = points[i];
    return merge_close(columns, faces);
}

}  // namespace drape
