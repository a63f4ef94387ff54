#include "mesh/flatten.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "mesh/topology.h"

namespace drape {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double flat = 1e-6;       // how far vertices of a flat mesh are off their plane, of its extent
constexpr double most_stretch = 2;  // of a parametrisation by UVs, over the mean
constexpr double rounding = 1e-6;   // of an area

void check_one_sheet(const Topology& topology) {
    if (topology.components != 1)
        throw Error(cat("it is in ", topology.components, " pieces (each must be a file of its own)"));
    if (topology.non_manifold_edges > 0)
        throw Error(cat(topology.non_manifold_edges, " of its edges have over two triangles"));
    if (topology.boundary_loops.empty()) throw Error("it is closed: it has no boundary to fill");
    std::set<int> seen;
    for (const std::vector<int>& loop : topology.boundary_loops)
        for (const int v : loop)
            if (!seen.insert(v).second) throw Error("its boundary touches itself");
}

double left_of(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

// Whether the whole mesh faces one way in the plane, with what area.
double area_to_the_right(const Mesh& mesh, const Eigen::Matrix2Xd& place) {
    double sum = 0, least = INFINITY;
    for (const auto& face : mesh.faces.colwise()) {
        const double area = -left_of(place.col(face[0]), place.col(face[1]), place.col(face[2])) / 2;
        sum += area;
        least = std::min(least, area);
    }
    if (!(least > 0)) return 0;
    return sum;
}

// In its own plane, if it has one.
bool lies_flat(const Mesh& mesh, FlatMesh& laid) {
    Vec3 normal = Vec3::Zero();
    for (const auto& face : mesh.faces.colwise()) {
        const Vec3 a = mesh.rest.col(face[0]);
        normal += Vec3(mesh.rest.col(face[1]) - a).cross(Vec3(mesh.rest.col(face[2]) - a));
    }
    if (!(normal.norm() > 0)) return false;
    normal.normalize();
    // to the last bit where the mesh is level
    for (int k = 0; k < 3; ++k)
        if (std::abs(normal[k]) > 1 - 1e-12) normal = Vec3::Unit(k) * (normal[k] > 0 ? 1 : -1);
    const Eigen::RowVectorXd height = normal.transpose() * mesh.rest;
    const double extent = (mesh.rest.rowwise().maxCoeff() - mesh.rest.rowwise().minCoeff()).norm();
    if (height.maxCoeff() - height.minCoeff() > flat * extent) return false;
    const Vec3 towards = std::abs(normal.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitZ();
    laid.across = (towards - normal.dot(towards) * normal).normalized();
    laid.down = laid.across.cross(normal);
    laid.origin = height.mean() * normal;
    laid.level = true;
    laid.place.resize(2, mesh.vertices());
    laid.place.row(0) = laid.across.transpose() * mesh.rest;
    laid.place.row(1) = laid.down.transpose() * mesh.rest;
    return true;
}

// By its UVs, in metres.
void lay_by_uv(const Mesh& mesh, FlatMesh& laid) {
    const Eigen::Matrix2Xd uv = mesh.drawn.uv.cast<double>();
    if (uv.cols() == 0) throw Error("it is curved and has no UVs to lay it flat by");
    laid.place.resize(2, mesh.vertices());
    for (size_t d = 0; d < mesh.drawn.vertex.size(); ++d)
        laid.place.col(mesh.drawn.vertex[d]) = uv.col(static_cast<Eigen::Index>(d));
    laid.place.row(1) *= -1;
    double in_plane = area_to_the_right(mesh, laid.place);
    if (in_plane == 0) {  // mirrored UVs
        laid.place.row(1) *= -1;
        in_plane = area_to_the_right(mesh, laid.place);
    }
    if (in_plane == 0) throw Error("it is curved and its UVs fold over: they do not lay it flat");
    double area = 0;
    for (const auto& face : mesh.faces.colwise()) {
        const Vec3 a = mesh.rest.col(face[0]);
        area += Vec3(mesh.rest.col(face[1]) - a).cross(Vec3(mesh.rest.col(face[2]) - a)).norm() / 2;
    }
    laid.place *= std::sqrt(area / in_plane);
    double most = 1;
    for (const auto& face : mesh.faces.colwise()) {
        Eigen::Matrix<double, 3, 2> sides;
        Eigen::Matrix2d in_uv;
        for (int k = 0; k < 2; ++k) {
            sides.col(k) = mesh.rest.col(face[k + 1]) - mesh.rest.col(face[0]);
            in_uv.col(k) = laid.place.col(face[k + 1]) - laid.place.col(face[0]);
        }
        const Eigen::Matrix<double, 3, 2> gradient = sides * in_uv.inverse();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> squares(gradient.transpose() * gradient);
        most = std::max({most, std::sqrt(squares.eigenvalues()[1]),
                         1 / std::sqrt(std::max(squares.eigenvalues()[0], 1e-300))});
    }
    if (most > most_stretch)
        throw Error(cat("it is curved and its UVs stretch it by ", most, " (at most ", most_stretch, ")"));
}

}  // namespace

FlatMesh flatten(const Mesh& mesh) {
    const Topology topology = build_topology(mesh.faces, mesh.vertices());
    check_one_sheet(topology);
    if (mesh.drawn.uv.cols() > mesh.vertices())
        throw Error("its UVs have a seam, across which they cannot be carried over");
    FlatMesh laid;
    if (!lies_flat(mesh, laid)) lay_by_uv(mesh, laid);
    std::vector<Loop> loops;
    for (const std::vector<int>& boundary : topology.boundary_loops) {
        loops.emplace_back();
        for (const int v : boundary) loops.back().push_back(laid.place.col(v));
    }
    const double area = area_to_the_right(mesh, laid.place);
    if (!(std::abs(area_between(loops) - area) <= rounding * area))
        throw Error("it overlaps itself where it lies flat");
    try {
        laid.outline = polygons_outline(loops);
    } catch (const Error&) {
        throw Error("its boundary touches itself where it lies flat");
    }
    return laid;
}

}  // namespace drape
