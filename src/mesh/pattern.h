// Generated cloth meshes: a rectangle cut into triangles by a pattern. A new pattern: its function in
// regular_patterns.cpp or irregular_patterns.cpp, its declaration in pattern_kinds.h, its row in the table
// (pattern.cpp), its sentence in the README; the tests loop over the table.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "mesh/mesh.h"

namespace drape {

struct PatternSize {
    double width = 1, depth = 1;  // along x and z [m]
    int columns = 32, rows = 32;  // quads along x and z
    std::uint64_t seed = 1;       // of patterns that throw dice
};

struct PatternKind {
    std::string_view name;
    std::string_view summary;
    Mesh (*make)(const PatternSize&);
    bool on_grid = false;  // its vertices are (columns + 1) x (rows + 1), row by row
};

std::span<const PatternKind> pattern_kinds();

// At least as many as the pattern will have, but for a few. Throws Error for an unknown name.
double about_vertices(std::string_view name, const PatternSize& size);

// A horizontal sheet centred on the origin at y = 0, front side up, uv = (x, z) / size from corner to corner.
// Vertices run row by row along x, of irregular patterns about so. Throws Error for an unknown name, a size
// that is not positive or too fine.
Mesh make_pattern(std::string_view name, const PatternSize& size);

}  // namespace drape
