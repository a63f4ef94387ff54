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

// u^2/2, uv/sqrt 2, v^2/2 at the points in units of size: their least squares do not depend on the axes
Eigen::MatrixXd quadratics(const Points2& points, double size) {
    Eigen::MatrixXd values(static_cast<Eigen::Index>(points.size()), 3);
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
        const Eigen::Vector2d s = points[static_cast<size_t>(i)].at / size;
        values.row(i) << s.x() * s.x() / 2, s.x() * s.y() / std::numbers::sqrt2, s.y() * s.y() / 2;
    }
    return values;
}

// Changes the weights least, and nothing for linear functions, so that quadratic ones have no slope at the
// origin, as is right for them. False where the points cannot tell quadratics well, unless that is accepted.
bool mend(const Points2& points, bool accept_incomplete, EdgeSlope& slope) {
    const auto count = static_cast<Eigen::Index>(points.size());
    if (count < 6 && !accept_incomplete) return false;
    const double size = size_of(points);
    Eigen::MatrixXd linear(count, 3);
    for (Eigen::Index i = 0; i < count; ++i)
        linear.row(i) << 1, points[static_cast<size_t>(i)].at.transpose() / size;
    const Eigen::MatrixXd quadratic = quadratics(points, size);
    Eigen::MatrixXd basis(count, 6);
    basis << linear, quadratic;
    const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(basis).singularValues();
    const Eigen::Index full = std::min<Eigen::Index>(count, 6);
    slope.condition = values[full - 1] > 0 ? values[0] / values[full - 1] : INFINITY;
    slope.complete = full == 6 && slope.condition <= worst_condition;
    if (!slope.complete && !accept_incomplete) return false;

    const Eigen::MatrixXd flat = linear.householderQr().householderQ() * Eigen::MatrixXd::Identity(count, 3);
    const Eigen::MatrixXd curved = quadratic - flat * (flat.transpose() * quadratic);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(curved, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd& told = svd.singularValues();
    // the pseudo-inverse, without the directions that the points cannot tell
    Eigen::VectorXd inverse = Eigen::VectorXd::Zero(told.size());
    for (Eigen::Index k = 0; k < told.size(); ++k)
        if (told[k] * worst_condition >= values[0]) inverse[k] = 1 / told[k];
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(count);
    weight.head<4>() = two_triangles(points);
    slope.weight = weight - svd.matrixU() * inverse.asDiagonal() * svd.matrixV().transpose() *
                                (quadratic.transpose() * weight);
    return true;
}

}  // namespace

EdgeSlope edge_slope(const Mesh& mesh, const Topology& topology, const Edge& edge) {
    Unfolding patch(mesh, topology, edge);
    EdgeSlope slope;
    slope.weight = two_triangles(patch.points());
    const Eigen::MatrixXd quadratic = quadratics(patch.points(), size_of(patch.points()));
    if ((quadratic.transpose() * slope.weight).norm() > round_off * slope.weight.norm()) {
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
