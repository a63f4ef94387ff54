#include "force/plate_element.h"

#include <Eigen/Dense>

namespace drape {

namespace {

// The triangle in its own plane, corner 0 at the origin, counterclockwise.
std::array<Eigen::Vector2d, 3> laid_flat(const std::array<Vec3, 3>& corner) {
    const Vec3 base = corner[1] - corner[0], leg = corner[2] - corner[0];
    const double length = base.norm();
    return {Eigen::Vector2d::Zero(), Eigen::Vector2d(length, 0),
            Eigen::Vector2d(leg.dot(base) / length, base.cross(leg).norm() / length)};
}

// Rows H_uu, H_uv, H_vv over d, times the area.
Eigen::Matrix<double, 3, 6> curvature_rows(const std::array<Eigen::Vector2d, 3>& p) {
    Eigen::Matrix<double, 3, 6> rows = Eigen::Matrix<double, 3, 6>::Zero();
    for (size_t c = 0; c < 3; ++c) {
        const size_t begin = (c + 1) % 3, end = (c + 2) % 3;
        const Eigen::Vector2d edge = p[end] - p[begin], t = edge.normalized(), n(t.y(), -t.x());
        const Vec3 twist(t.x() * n.x(), (t.x() * n.y() + t.y() * n.x()) / 2, t.y() * n.y());
        rows.col(static_cast<Eigen::Index>(end)) += twist;
        rows.col(static_cast<Eigen::Index>(begin)) -= twist;
        rows.col(static_cast<Eigen::Index>(3 + c)) =
            edge.norm() * Vec3(n.x() * n.x(), n.x() * n.y(), n.y() * n.y());
    }
    return rows;
}

// One unknown after the other: the block of free slopes of at most two edges is definite.
void eliminate(Matrix6& k, Eigen::Index slope) {
    const Eigen::Matrix<double, 6, 1> column = k.col(slope);
    k -= column * column.transpose() / column[slope];
    k.row(slope).setZero();
    k.col(slope).setZero();
}

}  // namespace

Matrix6 plate_stiffness(const std::array<Vec3, 3>& corner, double rigidity, double poisson,
                        const std::array<bool, 3>& free) {
    if (free[0] && free[1] && free[2]) return Matrix6::Zero();  // nothing bends it
    const auto flat = laid_flat(corner);
    const double area = flat[1].x() * flat[2].y() / 2;
    const Eigen::Matrix<double, 3, 6> rows = curvature_rows(flat);
    Eigen::Matrix3d moment;
    moment << 1, 0, poisson, 0, 2 * (1 - poisson), 0, poisson, 0, 1;
    Matrix6 k = rigidity / area * rows.transpose() * moment * rows;
    for (size_t c = 0; c < 3; ++c)
        if (free[c]) eliminate(k, static_cast<Eigen::Index>(3 + c));
    return k;
}

}  // namespace drape
