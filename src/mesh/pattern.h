// Generated cloth meshes: a rectangle, or a part of it, cut into triangles by a pattern. A new pattern: its
// function in regular_patterns.cpp or irregular_patterns.cpp, its declaration in pattern_kinds.h, its row in
// the table (pattern.cpp), its sentence in the README; the tests loop over the table.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "mesh/mesh.h"
#include "mesh/outline.h"
#include "mesh/size_field.h"

namespace drape {

struct PatternSize {
    double width = 1, depth = 1;          // along x and z [m]
    int columns = 32, rows = 32;          // quads along x and z
    std::uint64_t seed = 1;               // of patterns that throw dice
    std::string_view over = "rectangle";  // what of the rectangle is covered
    double hole = 0;                      // inner diameter of an annulus [m]; 0: half the outer
    std::vector<Eigen::Vector2d>
        outline{};  // corners (x, z), whose bounding box stands for width and depth [m]
    Finer finer{};  // of `adaptive`
};

struct PatternKind {
    std::string_view name;
    std::string_view summary;
    Mesh (*make)(const PatternSize&);  // over the rectangle
    bool on_grid = false;              // its vertices are (columns + 1) x (rows + 1), row by row
    int cell = 0;                      // how many triangles its rows repeat; 0: it has no rows
    // of one without rows, in the box from low to high
    SizeField (*edge_length)(const PatternSize&, const Eigen::Vector2d& low,
                             const Eigen::Vector2d& high) = nullptr;
};

std::span<const PatternKind> pattern_kinds();

// What a pattern may cover.
struct OverKind {
    std::string_view name, summary;
    Outline (*outline)(const PatternSize&);
};

std::span<const OverKind> over_kinds();

// At least as many as the pattern will have, but for a few. Throws Error for an unknown name.
double about_vertices(std::string_view name, const PatternSize& size);

// A horizontal sheet at y = 0, front side up, centred on the origin but where an outline places it, uv = (x,
// z) over its bounding box from corner to corner. Vertices run row by row along x, of irregular patterns and
// within outlines about so. Throws Error for an unknown name, a size that is not positive or too fine, an
// outline that is none.
Mesh make_pattern(std::string_view name, const PatternSize& size);

// The same within any outline; `size` has the divisions of its bounding box.
Mesh make_pattern(std::string_view name, const PatternSize& size, const Outline& outline);

}  // namespace drape
