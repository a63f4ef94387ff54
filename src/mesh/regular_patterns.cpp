// Patterns whose vertices stand in rows: quads cut one way, alternately, or crosswise; equilateral triangles.
#include <algorithm>
#include <cmath>

#include "mesh/pattern_kinds.h"

namespace drape {

namespace {

// Fills a mesh of known size, from unit coordinates.
class Sheet {
public:
    Sheet(const PatternSize& size, int vertices, int triangles)
        : size_(size), rest_(3, vertices), uv_(2, vertices), faces_(3, triangles) {}

    void vertex(double s, double t) {
        rest_.col(vertices_) = Vec3((s - 0.5) * size_.width, 0, (t - 0.5) * size_.depth);
        uv_.col(vertices_++) = Eigen::Vector2f(float(s), float(t));
    }
    // counter-clockwise seen from above
    void triangle(int a, int b, int c) { faces_.col(triangles_++) = Eigen::Vector3i(a, b, c); }
    Mesh mesh() { return plain_mesh(std::move(rest_), std::move(faces_), std::move(uv_)); }

private:
    const PatternSize& size_;
    Points rest_;
    Eigen::Matrix2Xf uv_;
    Faces faces_;
    int vertices_ = 0, triangles_ = 0;
};

// Cuts every quad along the diagonal that `rising(column, row)` chooses.
template <class Rising>
Mesh cut_grid(const PatternSize& size, Rising rising) {
    const int across = size.columns + 1, down = size.rows + 1;
    Sheet sheet(size, across * down, 2 * size.columns * size.rows);
    for (int j = 0; j < down; ++j)
        for (int i = 0; i < across; ++i) sheet.vertex(double(i) / size.columns, double(j) / size.rows);
    for (int j = 0; j < size.rows; ++j) {
        for (int i = 0; i < size.columns; ++i) {
            // corners of the quad; counter-clockwise seen from +y is a, d, c, b
            const int a = j * across + i, b = a + 1, c = b + across, d = a + across;
            if (rising(i, j)) {
                sheet.triangle(a, c, b);
                sheet.triangle(a, d, c);
            } else {
                sheet.triangle(a, d, b);
                sheet.triangle(b, d, c);
            }
        }
    }
    return sheet.mesh();
}

}  // namespace

Mesh make_one_way(const PatternSize& size) {
    return cut_grid(size, [](int, int) { return true; });
}

Mesh make_alternating(const PatternSize& size) {
    return cut_grid(size, [](int i, int j) { return (i + j) % 2 == 0; });
}

// A row of corners, then the row of centres between it and the next.
Mesh make_crossed(const PatternSize& size) {
    const int columns = size.columns, rows = size.rows, stride = 2 * columns + 1;
    Sheet sheet(size, stride * rows + columns + 1, 4 * columns * rows);
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) sheet.vertex(double(i) / columns, double(j) / rows);
        for (int i = 0; j < rows && i < columns; ++i) sheet.vertex((i + 0.5) / columns, (j + 0.5) / rows);
    }
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int a = j * stride + i, b = a + 1, d = a + stride, c = d + 1, centre = a + columns + 1;
            sheet.triangle(a, centre, b);
            sheet.triangle(b, centre, c);
            sheet.triangle(c, centre, d);
            sheet.triangle(d, centre, a);
        }
    }
    return sheet.mesh();
}

// Every second row is shifted by half a triangle and has a vertex on each side to end on.
Mesh make_equilateral(const PatternSize& size) {
    const int columns = size.columns;
    const double height = size.width / columns * std::sqrt(0.75);
    const int rows = static_cast<int>(std::max(1.0, std::round(size.depth / height)));
    const int odd = (rows + 1) / 2, vertices = (rows + 1) * (columns + 1) + odd;
    Sheet sheet(size, vertices, rows * (2 * columns + 1));
    for (int j = 0; j <= rows; ++j) {
        const int count = columns + 1 + j % 2;
        for (int i = 0; i < count; ++i) {
            const double at = j % 2 == 0 ? i : std::clamp(i - 0.5, 0.0, double(columns));
            sheet.vertex(at / columns, double(j) / rows);
        }
    }
    int first = 0;
    for (int j = 0; j < rows; ++j) {
        const int next = first + columns + 1 + j % 2;
        const bool rising = j % 2 == 0;  // the longer row is the next
        const int shorter = rising ? first : next, longer = rising ? next : first;
        const auto add = [&](int a, int b, int c) {
            rising ? sheet.triangle(a, b, c) : sheet.triangle(a, c, b);
        };
        for (int i = 0; i <= columns; ++i) {
            add(longer + i, longer + i + 1, shorter + i);
            if (i < columns) add(shorter + i, longer + i + 1, shorter + i + 1);
        }
        first = next;
    }
    return sheet.mesh();
}

}  // namespace drape
