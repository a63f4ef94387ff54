#include "mesh/irregular_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/delaunay.h"

namespace drape {

namespace {

using Vec2 = Eigen::Vector2d;

// Neighbours in the plane are neighbours in memory: strips of one edge length, each along x.
std::vector<Eigen::Index> order_by_strips(const Eigen::Matrix2Xd& points, double strip) {
    std::vector<Eigen::Index> order(static_cast<size_t>(points.cols()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const double low = points.row(1).minCoeff();
    const auto row = [&](Eigen::Index i) { return std::floor((points(1, i) - low) / strip); };
    std::sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) {
        if (row(i) != row(j)) return row(i) < row(j);
        return points(0, i) != points(0, j) ? points(0, i) < points(0, j) : points(1, i) < points(1, j);
    });
    return order;
}

// Between the shortest and the longest edge wanted at any point.
double middle_edge(const Eigen::Matrix2Xd& points, const SizeField& edge_length) {
    double least = INFINITY, most = 0;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        least = std::min(least, edge_length(points.col(i)));
        most = std::max(most, edge_length(points.col(i)));
    }
    return (least + most) / 2;
}

// Without the triangles whose centre is not inside.
Faces kept(const Faces& faces, const Eigen::Matrix2Xd& points, const Region& inside) {
    std::vector<Eigen::Index> inner;
    for (Eigen::Index f = 0; f < faces.cols(); ++f) {
        const Vec2 centre = (points.col(faces(0, f)) + points.col(faces(1, f)) + points.col(faces(2, f))) / 3;
        if (inside(centre)) inner.push_back(f);
    }
    return faces(Eigen::all, inner);
}

// x of the plane is x, its y is z; triangles are turned round, for seen from above z points down the page.
Mesh flat_sheet_in_order(const Eigen::Matrix2Xd& points, Faces faces) {
    Points rest = Points::Zero(3, points.cols());
    rest.row(0) = points.row(0);
    rest.row(2) = points.row(1);
    const Vec2 low = points.rowwise().minCoeff();
    const Eigen::Array2d extent = (points.rowwise().maxCoeff() - low).array();
    const Eigen::Matrix2Xf uv = ((points.colwise() - low).array().colwise() / extent).cast<float>();
    faces.row(1).swap(faces.row(2));
    return plain_mesh(std::move(rest), std::move(faces), uv);
}

}  // namespace

std::vector<Vec2> points_between(const Vec2& from, const Vec2& to, const SizeField& edge_length) {
    // edges up to each of many places along the way; points stand where that is a whole number
    constexpr int samples = 1000;
    std::vector<double> edges{0};
    for (int i = 0; i < samples; ++i) {
        const Vec2 middle = from + (i + 0.5) / samples * (to - from);
        edges.push_back(edges.back() + (to - from).norm() / samples / edge_length(middle));
    }
    const int count = std::max(1, static_cast<int>(std::lround(edges.back())));
    std::vector<Vec2> points;
    size_t at = 0;
    for (int i = 0; i < count; ++i) {
        const double wanted = edges.back() * i / count;
        while (at + 1 < samples && edges[at + 1] <= wanted) ++at;
        const double within = (wanted - edges[at]) / (edges[at + 1] - edges[at]);
        Vec2 p = from + (static_cast<double>(at) + within) / samples * (to - from);
        // a way along an axis is straight to the last bit
        if (from.y() == to.y()) p.y() = from.y();
        if (from.x() == to.x()) p.x() = from.x();
        points.push_back(p);
    }
    return points;
}

std::vector<Vec2> points_round(const std::vector<Vec2>& corners, const SizeField& edge_length) {
    std::vector<Vec2> points;
    for (size_t i = 0; i < corners.size(); ++i) {
        const std::vector<Vec2> side =
            points_between(corners[i], corners[(i + 1) % corners.size()], edge_length);
        points.insert(points.end(), side.begin(), side.end());
    }
    return points;
}

Mesh irregular_mesh(const std::vector<Vec2>& fixed, const Region& inside, const SizeField& edge_length,
                    std::uint64_t seed) {
    Eigen::Matrix2Xd points = poisson_disk(columns_of(fixed), inside, edge_length, seed);
    points = Eigen::Matrix2Xd(points(Eigen::all, order_by_strips(points, middle_edge(points, edge_length))));
    return flat_sheet_in_order(points, kept(delaunay(points), points, inside));
}

Mesh flat_sheet(const Eigen::Matrix2Xd& points, const Faces& faces, double strip) {
    const std::vector<Eigen::Index> order = order_by_strips(points, strip);
    std::vector<int> now(order.size());
    for (size_t i = 0; i < order.size(); ++i) now[static_cast<size_t>(order[i])] = static_cast<int>(i);
    return flat_sheet_in_order(points(Eigen::all, order),
                               faces.unaryExpr([&](int v) { return now[static_cast<size_t>(v)]; }));
}

Eigen::Matrix2Xd columns_of(const std::vector<Vec2>& points) {
    Eigen::Matrix2Xd columns(2, static_cast<Eigen::Index>(points.size()));
    for (size_t i = 0; i < points.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = points[i];
    return columns;
}

}  // namespace drape
