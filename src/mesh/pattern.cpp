#include "mesh/pattern.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/names.h"
#include "mesh/pattern_kinds.h"

namespace drape {

namespace {

constexpr long long most_vertices = 20'000'000;

constexpr std::array kinds{
    PatternKind{"one_way", "every diagonal the same way: stiffer along it, folds follow it", make_one_way,
                true},
    PatternKind{"alternating", "diagonals alternate from quad to quad: no direction preferred among the two",
                make_alternating, true},
    PatternKind{"crossed", "both diagonals of each quad, through a vertex in its centre", make_crossed},
    PatternKind{
        "equilateral",
        "equilateral triangles as wide as a column, in as many rows as fit: the same in all directions",
        make_equilateral},
    PatternKind{"pseudo_random",
                "Poisson-disk points in Delaunay triangles, as many as the divisions ask for; `seed` tells "
                "them apart",
                make_pseudo_random},
};

double about_vertices(const PatternKind& kind, const PatternSize& size) {
    const double columns = size.columns + 1.0, on_grid = columns * (size.rows + 1.0);
    if (kind.on_grid) return on_grid;
    // crossed: a centre a quad; equilateral: rows as the columns have it; pseudo_random: a long thin border
    const double rows = size.depth / size.width * size.columns / std::sqrt(0.75);
    const double edge = std::sqrt(size.width / size.columns * size.depth / size.rows);
    return std::max({2 * on_grid, columns * (rows + 1), 2 * (size.width + size.depth) / edge});
}

}  // namespace

std::span<const PatternKind> pattern_kinds() {
    return kinds;
}

double about_vertices(std::string_view name, const PatternSize& size) {
    return about_vertices(find_named(kinds, "pattern", name), size);
}

Mesh make_pattern(std::string_view name, const PatternSize& size) {
    const PatternKind& kind = find_named(kinds, "pattern", name);
    if (!(size.width > 0 && std::isfinite(size.width) && size.depth > 0 && std::isfinite(size.depth)))
        throw Error(cat("pattern size must be positive, got ", size.width, " x ", size.depth, " m"));
    if (size.columns < 1 || size.rows < 1)
        throw Error(cat("pattern divisions must be at least 1, got ", size.columns, " x ", size.rows));
    const double vertices = about_vertices(kind, size);
    if (!(vertices <= most_vertices))
        throw Error(cat("pattern of ", size.columns, " x ", size.rows, " divisions has some ", vertices,
                        " vertices (at most ", most_vertices, ")"));
    return kind.make(size);
}

}  // namespace drape
