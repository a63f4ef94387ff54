#include "force/plate_fit.h"

#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace drape {

namespace {

constexpr double worst_condition = 60;
constexpr int most_rings = 4;

struct Placed {
    int vertex;
    Eigen::Vector2d at;
};

// The neighbourhood of a triangle laid out flat, grown ring by ring.
class Unfolding {
public:
    Unfolding(const Mesh& mesh, const Topology& topology, int triangle)
        : mesh_(mesh), topology_(topology), front_{triangle}, seen_{triangle} {
        const auto corner = mesh.faces.col(triangle);
        const Vec3 a = mesh.rest.col(corner[0]), b = mesh.rest.col(corner[1]), c = mesh.rest.col(corner[2]);
        const double ab = (b - a).norm(), along = (c - a).dot(b - a) / ab;
        const double height = (b - a).cross(c - a).norm() / ab;
        const Eigen::Vector2d centre((ab + along) / 3, height / 3);
        points_ = {{corner[0], -centre},
                   {corner[1], Eigen::Vector2d(ab, 0) - centre},
                   {corner[2], Eigen::Vector2d(along, height) - centre}};
    }

    const std::vector<Placed>& points() const { return points_; }

    // Unfolds the triangles across the front's edges; false if there is none left.
    bool grow() {
        std::vector<int> next;
        for (const int f : front_) {
            for (int c = 0; c < 3; ++c) {
                const int across = neighbour_across(topology_, f, c);
                if (across < 0 || contains(across)) continue;
                seen_.push_back(across);
                next.push_back(across);
                place_far_corner(f, c, across);
            }
        }
        front_ = std::move(next);
        return !front_.empty();
    }

private:
    bool contains(int triangle) const {
        for (const int t : seen_)
            if (t == triangle) return true;
        return false;
    }
    const Placed* find(int vertex) const {
        for (const Placed& p : points_)
            if (p.vertex == vertex) return &p;
        return nullptr;
    }

    // The corner of `across` that is not on the shared edge goes to the far side of it, at its rest
    // distances.
    void place_far_corner(int face, int corner, int across) {
        const int i = mesh_.faces((corner + 1) % 3, face), j = mesh_.faces((corner + 2) % 3, face);
        int far = -1;
        for (int k = 0; k < 3; ++k)
            if (mesh_.faces(k, across) != i && mesh_.faces(k, across) != j) far = mesh_.faces(k, across);
        if (far < 0 || find(far)) return;  // reached another way round already
        const Placed *p = find(i), *q = find(j), *inner = find(mesh_.faces(corner, face));
        if (!p || !q || !inner) return;
        const Vec3 xi = mesh_.rest.col(i), xj = mesh_.rest.col(j), xf = mesh_.rest.col(far);
        const double length = (xj - xi).norm(), along = (xf - xi).dot(xj - xi) / length;
        const double away = (xj - xi).cross(xf - xi).norm() / length;
        const Eigen::Vector2d edge = (q->at - p->at).normalized();
        Eigen::Vector2d side(-edge.y(), edge.x());
        if (side.dot(inner->at - p->at) > 0) side = -side;
        points_.push_back({far, p->at + along * edge + away * side});
    }

    const Mesh& mesh_;
    const Topology& topology_;
    std::vector<int> front_, seen_;
    std::vector<Placed> points_;
};

// Least squares for g ~ c0 + c1 u + c2 v + c3 u^2/2 + c4 uv + c5 v^2/2; coordinates scaled to size 1.
// Constant and linear functions are taken out first, so that whatever the points cannot tell, moving and
// tilting never looks like curvature; of the curvatures that fit equally well the one of least norm is taken.
bool fit(const std::vector<Placed>& points, bool accept_incomplete, CurvatureStencil& stencil) {
    const auto count = static_cast<Eigen::Index>(points.size());
    if (count < 6 && !accept_incomplete) return false;
    double size = 0;
    for (const Placed& p : points) size = std::max(size, p.at.norm());
    // uv over sqrt 2: c3^2 + 2 c4^2 + c5^2 is the norm that does not depend on the axes
    Eigen::MatrixXd linear(count, 3), quadratic(count, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Vector2d s = points[static_cast<size_t>(i)].at / size;
        linear.row(i) << 1, s.x(), s.y();
        quadratic.row(i) << s.x() * s.x() / 2, s.x() * s.y() / std::numbers::sqrt2, s.y() * s.y() / 2;
    }
    Eigen::MatrixXd basis(count, 6);
    basis << linear, quadratic;
    const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(basis).singularValues();
    const Eigen::Index full = std::min<Eigen::Index>(count, 6);
    stencil.condition = values[full - 1] > 0 ? values[0] / values[full - 1] : INFINITY;
    stencil.complete = full == 6 && stencil.condition <= worst_condition;
    if (!stencil.complete && !accept_incomplete) return false;

    const Eigen::MatrixXd flat = linear.householderQr().householderQ() * Eigen::MatrixXd::Identity(count, 3);
    const Eigen::MatrixXd curved = quadratic - flat * (flat.transpose() * quadratic);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(curved, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd& seen = svd.singularValues();
    // the pseudo-inverse, without the directions that the points cannot tell
    Eigen::VectorXd inverse = Eigen::VectorXd::Zero(seen.size());
    for (Eigen::Index k = 0; k < seen.size(); ++k)
        if (seen[k] * worst_condition >= values[0]) inverse[k] = 1 / seen[k];
    const Eigen::MatrixXd solve = svd.matrixV() * inverse.asDiagonal() * svd.matrixU().transpose();
    stencil.weight = (solve - solve * flat * flat.transpose()) / (size * size);
    stencil.weight.row(1) /= std::numbers::sqrt2;
    stencil.vertex.clear();
    for (const Placed& p : points) stencil.vertex.push_back(p.vertex);
    return true;
}

}  // namespace

CurvatureStencil curvature_stencil(const Mesh& mesh, const Topology& topology, int triangle) {
    Unfolding patch(mesh, topology, triangle);
    CurvatureStencil stencil;
    for (int ring = 0; ring < most_rings; ++ring) {
        const bool grew = patch.grow();
        if (fit(patch.points(), false, stencil)) return stencil;
        if (!grew) break;
    }
    fit(patch.points(), true, stencil);
    return stencil;
}

}  // namespace drape
