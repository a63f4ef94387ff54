// Patterns without rows: Poisson-disk points, joined by their Delaunay triangulation, between straight sides.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/delaunay.h"
#include "mesh/pattern_kinds.h"
#include "mesh/poisson_disk.h"

namespace drape {

namespace {

using Vec2 = Eigen::Vector2d;

// Points on the rectangle's sides, in order round it, as far apart as the size field has it.
Eigen::Matrix2Xd rectangle_border(const Vec2& half, const SizeField& edge_length) {
    const Vec2 corner[] = {
        {-half.x(), -half.y()}, {half.x(), -half.y()}, {half.x(), half.y()}, {-half.x(), half.y()}};
    std::vector<Vec2> border;
    for (int side = 0; side < 4; ++side) {
        const Vec2 from = corner[side], to = corner[(side + 1) % 4];
        // edges up to each of many places along the side; points stand where that is a whole number
        constexpr int samples = 1000;
        std::vector<double> edges{0};
        for (int i = 0; i < samples; ++i) {
            const Vec2 middle = from + (i + 0.5) / samples * (to - from);
            edges.push_back(edges.back() + (to - from).norm() / samples / edge_length(middle));
        }
        const int count = std::max(1, static_cast<int>(std::lround(edges.back())));
        size_t at = 0;
        for (int i = 0; i < count; ++i) {
            const double wanted = edges.back() * i / count;
            while (at + 1 < samples && edges[at + 1] <= wanted) ++at;
            const double within = (wanted - edges[at]) / (edges[at + 1] - edges[at]);
            Vec2 p = from + (static_cast<double>(at) + within) / samples * (to - from);
            // a side is straight to the last bit
            if (side % 2 == 0)
                p.y() = from.y();
            else
                p.x() = from.x();
            border.push_back(p);
        }
    }
    Eigen::Matrix2Xd columns(2, static_cast<Eigen::Index>(border.size()));
    for (size_t i = 0; i < border.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = border[i];
    return columns;
}

// Neighbours in the plane are neighbours in memory: strips of one edge length, each along x.
void order_by_strips(Eigen::Matrix2Xd& points, double strip) {
    std::vector<Eigen::Index> order(static_cast<size_t>(points.cols()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const double low = points.row(1).minCoeff();
    const auto row = [&](Eigen::Index i) { return std::floor((points(1, i) - low) / strip); };
    std::sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) {
        if (row(i) != row(j)) return row(i) < row(j);
        return points(0, i) != points(0, j) ? points(0, i) < points(0, j) : points(1, i) < points(1, j);
    });
    points = Eigen::Matrix2Xd(points(Eigen::all, order));
}

Mesh mesh_of(const PatternSize& size, const Eigen::Matrix2Xd& points) {
    const Eigen::Index count = points.cols();
    Points rest = Points::Zero(3, count);
    rest.row(0) = points.row(0);
    rest.row(2) = points.row(1);
    const Eigen::Vector2d extent(size.width, size.depth);
    const Eigen::Matrix2Xf uv =
        ((points.array().colwise() / extent.array()) + 0.5).max(0.0).min(1.0).matrix().cast<float>();
    Faces faces = delaunay(points);
    faces.row(1).swap(faces.row(2));  // seen from above, z points down the page
    return plain_mesh(std::move(rest), std::move(faces), uv);
}

}  // namespace

Mesh make_pseudo_random(const PatternSize& size) {
    const Vec2 half(size.width / 2, size.depth / 2);
    const double edge = std::sqrt(size.width / size.columns * size.depth / size.rows);
    const SizeField edge_length = [edge](const Vec2&) { return edge; };
    const Region inside = [&](const Vec2& p) {
        return std::abs(p.x()) < half.x() && std::abs(p.y()) < half.y();
    };
    Eigen::Matrix2Xd points =
        poisson_disk(rectangle_border(half, edge_length), inside, edge_length, size.seed);
    order_by_strips(points, edge);
    return mesh_of(size, points);
}

}  // namespace drape
