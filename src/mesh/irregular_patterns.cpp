// Patterns without rows: Poisson-disk points, joined by their Delaunay triangulation, between straight sides.
#include <cmath>

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

}  // namespace drape
