#include "force/edge_slope.h"

#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include "force/unfolding.h"

namespace drape {

namespace {

constexpr double worst_condition = 60;
constexpr int most_rings = 4;
constexpr double round_off = 1e-12;

using Points2 = std::vector<Unfolding::Placed>;

double size_of(const Points2& points) {
    double size = 0;
    for (const auto& p : points) size = std::max(size, p.at.norm());
    return size;
}

// of the first four points of an Unfolding; exact for linear functions
Eigen::Vector4d two_triangles(const Points2& points) {
    const double length = 2 * points[1].at.x();
    const double below = -points[2].at.y(), above = points[3].at.y();
    Eigen::Vector4d weight(0, 0, -above / below, below / above);
    for (const size_t apex : {size_t{2}, size_t{3}}) {
        const double along = 0.5 + points[apex].at.x() / length, w = weight[static_cast<Eigen::Index>(apex)];
        weight[0] -= w * (1 - along);
        weight[1] -= w * along;
    }
    return weight / (below + above);
}

// 1, u, v, u^2/2, uv/sqrt 2, v^2/2 at a point in units of size: least squares of the last three do not depend
// on the axes
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

Vec6 monomials(const Eigen::Vector2d& at, double size) {
    const Eigen::Vector2d s = at / size;
    Vec6 values;
    values << 1, s.x(), s.y(), s.x() * s.x() / 2, s.x() * s.y() / std::numbers::sqrt2, s.y() * s.y() / 2;
    return values;
}

// What the two triangles make of quadratic functions, which have no slope at the origin.
Vec3 wrong_slopes(const Points2& points, double size) {
    const Eigen::Vector4d weight = two_triangles(points);
    Vec3 wrong = Vec3::Zero();
    for (size_t i = 0; i < 4; ++i)
        wrong += weight[static_cast<Eigen::Index>(i)] * monomials(points[i].at, size).tail<3>();
    return wrong;
}

// Changes the weights least, and nothing for linear functions, so that quadratic ones have no slope at the
// origin. With L and Q the values of linear and quadratic functions at the points, the change is
//   -C (C' C)^-1 wrong,  C = Q - L (L' L)^-1 L' Q
// False where the points cannot tell quadratics well, unless that is accepted.
bool mend(const Points2& points, bool accept_incomplete, EdgeSlope& slope) {
    if (points.size() < 6 && !accept_incomplete) return false;
    const double size = size_of(points);
    Mat6 gram = Mat6::Zero();
    for (const auto& p : points) {
        const Vec6 values = monomials(p.at, size);
        gram += values * values.transpose();
    }
    const Vec6 squares = Eigen::SelfAdjointEigenSolver<Mat6>(gram, Eigen::EigenvaluesOnly).eigenvalues();
    slope.condition = squares[0] > 0 ? std::sqrt(squares[5] / squares[0]) : INFINITY;
    slope.complete = points.size() >= 6 && slope.condition <= worst_condition;
    if (!slope.complete && !accept_incomplete) return false;

    const Mat3 linear_part = gram.topLeftCorner<3, 3>().inverse() * gram.topRightCorner<3, 3>();
    const Mat3 curved = gram.bottomRightCorner<3, 3>() - gram.bottomLeftCorner<3, 3>() * linear_part;
    const Eigen::SelfAdjointEigenSolver<Mat3> told(curved);
    // without the directions that the points cannot tell
    Vec3 inverse = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
        if (told.eigenvalues()[k] * worst_condition * worst_condition >= squares[5])
            inverse[k] = 1 / told.eigenvalues()[k];
    const Vec3 change = told.eigenvectors() * inverse.asDiagonal() * told.eigenvectors().transpose() *
                        wrong_slopes(points, size);
    slope.weight = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(points.size()));
    slope.weight.head<4>() = two_triangles(points);
    for (size_t i = 0; i < points.size(); ++i) {
        const Vec6 values = monomials(points[i].at, size);
        slope.weight[static_cast<Eigen::Index>(i)] -=
            (values.tail<3>() - linear_part.transpose() * values.head<3>()).dot(change);
    }
    return true;
}

}  // namespace

EdgeSlope edge_slope(const Mesh& mesh, const Topology& topology, const Edge& edge) {
    Unfolding patch(mesh, topology, edge);
    EdgeSlope slope;
    slope.weight = two_triangles(patch.points());
    const double wrong = wrong_slopes(patch.points(), size_of(patch.points())).norm();
    if (wrong > round_off * slope.weight.norm()) {
        bool mended = false;
        for (int ring = 0; ring < most_rings && !mended; ++ring) {
            const bool grew = patch.grow();
            mended = mend(patch.points(), false, slope);
            if (!grew) break;
        }
        if (!mended) mend(patch.points(), true, slope);
    }
    for (const auto& p : patch.points()) slope.vertex.push_back(p.vertex);
    return slope;
}

}  // namespace drape
