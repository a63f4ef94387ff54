#include "mesh/pattern.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/names.h"
#include "mesh/cut_pattern.h"
#include "mesh/fill.h"
#include "mesh/pattern_kinds.h"

namespace drape {

namespace {

constexpr long long most_vertices = 20'000'000;

constexpr std::array kinds{
    PatternKind{"one_way", "every diagonal the same way: stiffer along it", make_one_way, true, 2},
    PatternKind{
        "alternating",
        "diagonals alternate from quad to quad: nearly as stiff along all, folds follow rows and columns",
        make_alternating, true, 2},
    PatternKind{"crossed",
                "both diagonals of each quad, through a vertex in its centre: folds follow diagonals",
                make_crossed, false, 4},
    PatternKind{
        "equilateral",
        "equilateral triangles as wide as a column, in as many rows as fit: the same in all directions",
        make_equilateral, false, 1},
    PatternKind{"pseudo_random",
                "Poisson-disk points in Delaunay triangles, as many as the divisions ask for; `seed` tells "
                "them apart",
                make_pseudo_random, false, 0, even_edges},
    PatternKind{
        "adaptive",
        "the same, finer near points and lines, or where an earlier run was curved, as `finer` has it",
        make_adaptive, false, 0, adaptive_edges},
};

constexpr std::array overs{
    OverKind{"rectangle", "all of it",
             [](const PatternSize& size) { return rectangle_outline(size.width, size.depth); }},
    OverKind{"disc", "a disc as wide as the square `size`",
             [](const PatternSize& size) { return disc_outline(size.width); }},
    OverKind{"annulus", "such a disc with a `hole` in its middle",
             [](const PatternSize& size) {
                 return annulus_outline(size.width, size.hole > 0 ? size.hole : size.width / 2);
             }},
    OverKind{"outline", "a polygon, `outline`, in place of `size`",
             [](const PatternSize& size) { return polygon_outline(size.outline); }},
};

double about_vertices(const PatternKind& kind, const PatternSize& size) {
    const double columns = size.columns + 1.0, on_grid = columns * (size.rows + 1.0);
    if (kind.on_grid) return on_grid;
    // crossed: a centre a quad; equilateral: rows as the columns have it; irregular ones: a long thin border
    const double rows = size.depth / size.width * size.columns / std::sqrt(0.75);
    const double edge = std::sqrt(size.width / size.columns * size.depth / size.rows);
    const double even = std::max({2 * on_grid, columns * (rows + 1), 2 * (size.width + size.depth) / edge});
    if (!kind.edge_length || !size.finer.anywhere()) return even;
    const Eigen::Vector2d half(size.width / 2, size.depth / 2);
    return std::max(even, 1.2 * vertices_asked(kind.edge_length(size, -half, half), -half, half));
}

void check(const PatternKind& kind, const PatternSize& size) {
    if (!(size.width > 0 && std::isfinite(size.width) && size.depth > 0 && std::isfinite(size.depth)))
        throw Error(cat("pattern size must be positive, got ", size.width, " x ", size.depth, " m"));
    if (size.columns < 1 || size.rows < 1)
        throw Error(cat("pattern divisions must be at least 1, got ", size.columns, " x ", size.rows));
    if ((size.over == "disc" || size.over == "annulus") && size.width != size.depth)
        throw Error(cat("a pattern over a ", size.over, " needs a square size, got ", size.width, " x ",
                        size.depth, " m"));
    if (size.over == "annulus" && !(size.hole >= 0 && size.hole < size.width))
        throw Error(
            cat("the hole of an annulus must be narrower than its ", size.width, " m, got ", size.hole));
    const double vertices = about_vertices(kind, size);
    if (!(vertices <= most_vertices))
        throw Error(cat("pattern of ", size.columns, " x ", size.rows, " divisions has some ", vertices,
                        " vertices (at most ", most_vertices, ")"));
}

// The divisions belong to the outline's bounding box.
PatternSize boxed(PatternSize size, const Outline& outline) {
    const Eigen::Vector2d extent = outline.high() - outline.low();
    size.width = extent.x();
    size.depth = extent.y();
    return size;
}

Mesh within(const PatternKind& kind, const PatternSize& size, const Outline& outline) {
    if (kind.edge_length)
        return irregular_within(outline, kind.edge_length(size, outline.low(), outline.high()), size.seed);
    Mesh grid = kind.make(size);
    const Eigen::Vector2d centre = (outline.low() + outline.high()) / 2;
    grid.rest.colwise() += Vec3(centre.x(), 0, centre.y());
    const double width = size.width / size.columns, depth = size.depth / size.rows;
    return cut_pattern(grid, kind.cell, outline, kind.cell == 1 ? width : std::sqrt(width * depth));
}

}  // namespace

std::span<const PatternKind> pattern_kinds() {
    return kinds;
}

std::span<const OverKind> over_kinds() {
    return overs;
}

double about_vertices(std::string_view name, const PatternSize& size) {
    const PatternKind& kind = find_named(kinds, "pattern", name);
    return about_vertices(kind, size.over == "outline" ? boxed(size, polygon_outline(size.outline)) : size);
}

Mesh make_pattern(std::string_view name, const PatternSize& size) {
    const PatternKind& kind = find_named(kinds, "pattern", name);
    const OverKind& over = find_named(overs, "what a pattern covers", size.over);
    if (over.name == "outline") return make_pattern(name, size, over.outline(size));
    check(kind, size);
    return over.name == "rectangle" ? kind.make(size) : within(kind, size, over.outline(size));
}

Mesh make_pattern(std::string_view name, const PatternSize& size, const Outline& outline) {
    const PatternKind& kind = find_named(kinds, "pattern", name);
    const PatternSize box = boxed(size, outline);
    check(kind, box);
    return within(kind, box, outline);
}

}  // namespace drape
