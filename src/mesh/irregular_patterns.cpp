// Patterns without rows: Poisson-disk points, joined by their Delaunay triangulation, between straight sides.
#include <cmath>

#include "mesh/fill.h"
#include "mesh/irregular_mesh.h"
#include "mesh/pattern_kinds.h"

namespace drape {

Mesh make_pseudo_random(const PatternSize& size) {
    const Eigen::Vector2d half(size.width / 2, size.depth / 2);
    const double edge = std::sqrt(size.width / size.columns * size.depth / size.rows);
    const SizeField edge_length = [edge](const Eigen::Vector2d&) { return edge; };
    const Region inside = [&](const Eigen::Vector2d& p) {
        return std::abs(p.x()) < half.x() && std::abs(p.y()) < half.y();
    };
    const std::vector<Eigen::Vector2d> sides = points_round(
        {{-half.x(), -half.y()}, {half.x(), -half.y()}, {half.x(), half.y()}, {-half.x(), half.y()}},
        edge_length);
    return irregular_mesh(sides, inside, edge_length, size.seed);
}

Mesh make_adaptive(const PatternSize& size) {
    const Outline outline = rectangle_outline(size.width, size.depth);
    return irregular_within(outline, adaptive_edges(size, outline.low(), outline.high()), size.seed);
}

SizeField even_edges(const PatternSize& size, const Eigen::Vector2d&, const Eigen::Vector2d&) {
    const double edge = std::sqrt(size.width / size.columns * size.depth / size.rows);
    return [edge](const Eigen::Vector2d&) { return edge; };
}

SizeField adaptive_edges(const PatternSize& size, const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    return finer_field(size.finer, std::sqrt(size.width / size.columns * size.depth / size.rows), low, high);
}

}  // namespace drape
