#include "mesh/pattern.h"

#include <array>
#include <cmath>

#include "base/error.h"
#include "base/names.h"

namespace drape {

namespace {

constexpr long long most_vertices = 20'000'000;

// Cuts every quad along the diagonal that `rising(column, row)` chooses.
template <class Rising>
Mesh cut_grid(const PatternSize& size, Rising rising) {
    const int across = size.columns + 1, down = size.rows + 1;
    Points rest(3, across * down);
    Eigen::Matrix2Xf uv(2, across * down);
    for (int j = 0; j < down; ++j) {
        for (int i = 0; i < across; ++i) {
            const double s = double(i) / size.columns, t = double(j) / size.rows;
            rest.col(j * across + i) = Vec3((s - 0.5) * size.width, 0, (t - 0.5) * size.depth);
            uv.col(j * across + i) = Eigen::Vector2f(float(s), float(t));
        }
    }
    Faces faces(3, 2 * size.columns * size.rows);
    int f = 0;
    for (int j = 0; j < size.rows; ++j) {
        for (int i = 0; i < size.columns; ++i) {
            // corners of the quad; counter-clockwise seen from +y is a, d, c, b
            const int a = j * across + i, b = a + 1, c = b + across, d = a + across;
            if (rising(i, j)) {
                faces.col(f++) = Eigen::Vector3i(a, c, b);
                faces.col(f++) = Eigen::Vector3i(a, d, c);
            } else {
                faces.col(f++) = Eigen::Vector3i(a, d, b);
                faces.col(f++) = Eigen::Vector3i(b, d, c);
            }
        }
    }
    return plain_mesh(std::move(rest), std::move(faces), std::move(uv));
}

Mesh one_way(const PatternSize& size) {
    return cut_grid(size, [](int, int) { return true; });
}

Mesh alternating(const PatternSize& size) {
    return cut_grid(size, [](int i, int j) { return (i + j) % 2 == 0; });
}

constexpr std::array kinds{
    PatternKind{"one_way", "every diagonal the same way: stiffer along it, folds follow it", one_way},
    PatternKind{"alternating", "diagonals alternate from quad to quad: no direction preferred among the two",
                alternating},
};

}  // namespace

std::span<const PatternKind> pattern_kinds() {
    return kinds;
}

Mesh make_pattern(std::string_view name, const PatternSize& size) {
    const PatternKind& kind = find_named(kinds, "pattern", name);
    if (!(size.width > 0 && std::isfinite(size.width) && size.depth > 0 && std::isfinite(size.depth)))
        throw Error(cat("pattern size must be positive, got ", size.width, " x ", size.depth, " m"));
    if (size.columns < 1 || size.rows < 1)
        throw Error(cat("pattern divisions must be at least 1, got ", size.columns, " x ", size.rows));
    const long long vertices = (size.columns + 1LL) * (size.rows + 1LL);
    if (vertices > most_vertices)
        throw Error(cat("pattern of ", size.columns, " x ", size.rows, " divisions has ", vertices,
                        " vertices (at most ", most_vertices, ")"));
    return kind.make(size);
}

}  // namespace drape
