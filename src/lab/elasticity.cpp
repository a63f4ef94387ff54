#include "lab/elasticity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include "base/assert.h"
#include "lab/elastic.h"

namespace drape {

namespace {

constexpr double window = 0.6;  // share of the sheet's width and depth where energy is counted
constexpr double softness =
    1e-9;  // of the stiffness, that holds a flat sheet against moving out of its plane
constexpr int degrees_apart = 3;

double along(const Mat3& stiffness, const Eigen::Vector3d& stress) {
    return 1 / stress.dot(stiffness.ldlt().solve(stress));
}

DirectionCurve curve_of(const Elasticity& elasticity, double (Elasticity::*modulus)(double) const) {
    DirectionCurve curve;
    for (int degrees = 0; degrees < 180; degrees += degrees_apart) {
        curve.angle_deg.push_back(degrees);
        curve.value.push_back((elasticity.*modulus)(degrees * std::numbers::pi / 180));
        curve.mean += curve.value.back() * degrees_apart / 180;
    }
    curve.least = *std::min_element(curve.value.begin(), curve.value.end());
    curve.most = *std::max_element(curve.value.begin(), curve.value.end());
    return curve;
}

// exx, eyy or gxy of 1
Points strained(const Points& rest, int component) {
    Points move = Points::Zero(3, rest.cols());
    if (component == 0) move.row(0) = rest.row(0);
    if (component == 1) move.row(2) = rest.row(2);
    if (component == 2) {
        move.row(0) = rest.row(2) / 2;
        move.row(2) = rest.row(0) / 2;
    }
    return move;
}

// Which triangles count, and their area [m^2]. Of finite elements all do, for they strain alike up to the
// border.
struct Middle {
    std::vector<bool> counts;
    std::vector<double> areas;
    double area = 0;

    explicit Middle(const Cloth& cloth) {
        const Mesh& mesh = cloth.mesh;
        const Vec3 low = mesh.rest.rowwise().minCoeff(), high = mesh.rest.rowwise().maxCoeff();
        const double share = cloth.fabric.membrane == MembraneKind::none ? window : 1;
        const Vec3 centre = (low + high) / 2, reach = (high - low) / 2 * share;
        for (int f = 0; f < mesh.triangles(); ++f) {
            const Vec3 a = mesh.rest.col(mesh.faces(0, f)), b = mesh.rest.col(mesh.faces(1, f));
            const Vec3 c = mesh.rest.col(mesh.faces(2, f)), from = ((a + b + c) / 3 - centre).cwiseAbs();
            counts.push_back(from.x() < reach.x() && from.z() < reach.z());
            areas.push_back((b - a).cross(c - a).norm() / 2);
            if (counts.back()) area += areas.back();
        }
    }
};

// The cloth with no stiffness beyond its middle: an edge keeps the share of its triangles that count.
void leave_middle(Cloth& cloth, const Middle& middle) {
    std::vector<double> share(cloth.network.edges.size(), 0);
    for (int f = 0; f < cloth.mesh.triangles(); ++f) {
        const auto triangle = static_cast<size_t>(f);
        for (int k = 0; k < 3; ++k) {
            const auto e = static_cast<size_t>(cloth.topology.face_edges(k, f));
            if (middle.counts[triangle]) share[e] += 1.0 / cloth.topology.edges[e].face_count;
        }
        if (cloth.network.altitudes.empty() || middle.counts[triangle]) continue;
        cloth.network.altitudes[triangle].weight.setZero();
        cloth.network.altitudes[triangle].common_weight = 0;
    }
    for (size_t e = 0; e < share.size(); ++e) cloth.network.edges[e].stiffness *= share[e];
}

// (exx, eyy, gxy) of a move, on average over the middle: not quite what the border was given, where a softer
// or stiffer rim takes more or less of it.
Eigen::Vector3d strain_in(const Middle& middle, const Mesh& mesh, const Points& move) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int f = 0; f < mesh.triangles(); ++f)
        if (middle.counts[static_cast<size_t>(f)])
            sum += middle.areas[static_cast<size_t>(f)] * strain_of(mesh, f, move);
    return sum / middle.area;
}

}  // namespace

double Elasticity::stretch_modulus(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return along(stiffness, {c * c, s * s, c * s});
}

double Elasticity::shear_modulus(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return along(stiffness, {-2 * c * s, 2 * c * s, c * c - s * s});
}

DirectionCurve stretch_curve(const Elasticity& elasticity) {
    return curve_of(elasticity, &Elasticity::stretch_modulus);
}

DirectionCurve shear_curve(const Elasticity& elasticity) {
    return curve_of(elasticity, &Elasticity::shear_modulus);
}

Eigen::Vector3d strain_of(const Mesh& mesh, int triangle, const Points& move) {
    const auto side = [&](const Points& points, int corner) {
        const Vec3 d = points.col(mesh.faces(corner, triangle)) - points.col(mesh.faces(0, triangle));
        return Eigen::Vector2d(d.x(), d.z());
    };
    Eigen::Matrix2d rest, moved;
    rest << side(mesh.rest, 1), side(mesh.rest, 2);
    moved << side(move, 1), side(move, 2);
    const Eigen::Matrix2d gradient = moved * rest.inverse();
    return {gradient(0, 0), gradient(1, 1), gradient(0, 1) + gradient(1, 0)};
}

// With the move u of all vertices the free ones shift by w besides: K_ff w = -(K u)_f.
std::vector<Points> settle(const Model& free, const std::vector<int>& held, std::vector<Points> moves) {
    Model pinned = free;
    hold_at_rest(pinned, held);
    const BlockMatrix whole = stiffness_of(free, free.cloths.front().mesh.rest);
    BlockMatrix inner = stiffness_of(pinned, pinned.cloths.front().mesh.rest);
    inner.add_masses(softness * whole.lower().diagonal().maxCoeff() / free.mass.maxCoeff());
    // the vertices are numbered for a sparse factor already
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(
        inner.lower());
    DRAPE_ASSERT(factor.info() == Eigen::Success);
    Eigen::VectorXd pull;
    Points shift(3, free.vertices());
    for (Points& move : moves) {
        inner.gather(whole.multiply(move), pull);
        inner.scatter(factor.solve(pull), shift);
        move -= shift;
    }
    return moves;
}

Elasticity measure_elasticity(const Mesh& sheet, const Fabric& fabric) {
    Model free = free_cloth(sheet, fabric);
    std::vector<int> border;
    for (const std::vector<int>& loop : free.cloths.front().topology.boundary_loops)
        border.insert(border.end(), loop.begin(), loop.end());
    const std::vector<Points> move =
        settle(free, border, {strained(sheet.rest, 0), strained(sheet.rest, 1), strained(sheet.rest, 2)});
    const Middle middle(free.cloths.front());
    leave_middle(free.cloths.front(), middle);
    const BlockMatrix counted = stiffness_of(free, free.cloths.front().mesh.rest);
    // moves i and j store e_i' C e_j, e_i being the middle's strain under move i
    Mat3 stored, strain;
    for (Eigen::Index j = 0; j < 3; ++j) {
        const Points force = counted.multiply(move[static_cast<size_t>(j)]);
        for (Eigen::Index i = 0; i < 3; ++i)
            stored(i, j) = move[static_cast<size_t>(i)].cwiseProduct(force).sum() / middle.area;
        strain.col(j) = strain_in(middle, sheet, move[static_cast<size_t>(j)]);
    }
    const Mat3 back = strain.inverse();
    return {back.transpose() * stored * back};
}

}  // namespace drape
