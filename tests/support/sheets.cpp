#include "support/sheets.h"

#include <cmath>
#include <numbers>

namespace drape::test {

Fabric bending_fabric(BendingKind kind, double bending) {
    Fabric fabric = bare_springs(50);
    fabric.bending_kind = kind;
    fabric.bending = bending;
    return fabric;
}

Mesh equilateral_sheet(int divisions) {
    Mesh mesh = square(divisions, "alternating");
    const int across = divisions + 1;
    mesh.rest.row(2) *= std::sqrt(3.0) / 2;
    int f = 0;
    for (int j = 0; j < across; ++j) {
        if (j % 2 == 1) mesh.rest.row(0).segment(j * across, across).array() += 0.5 / divisions;
        for (int i = 0; j < divisions && i < divisions; ++i) {
            const int a = j * across + i, b = a + 1, c = b + across, d = a + across;
            const bool rising = j % 2 == 1;
            mesh.faces.col(f++) = rising ? Eigen::Vector3i(a, c, b) : Eigen::Vector3i(a, d, b);
            mesh.faces.col(f++) = rising ? Eigen::Vector3i(a, d, c) : Eigen::Vector3i(b, d, c);
        }
    }
    return plain_mesh(mesh.rest, mesh.faces);
}

std::vector<Sheet> every_sheet(int divisions) {
    std::vector<Sheet> sheets{{"equilateral", equilateral_sheet(divisions)}};
    for (const PatternKind& kind : pattern_kinds()) {
        sheets.push_back({std::string(kind.name), square(divisions, kind.name)});
        if (kind.edge_length) continue;  // shifts could turn its smallest triangles over
        sheets.push_back(
            {std::string(kind.name) + ", jittered", jittered_square(divisions, kind.name, 0.25)});
    }
    return sheets;
}

Points lifted(const Mesh& mesh, const std::function<double(double, double)>& height) {
    Points x = mesh.rest;
    for (Eigen::Index i = 0; i < x.cols(); ++i) x(1, i) = height(x(0, i), x(2, i));
    return x;
}

Points rolled(const Mesh& mesh, double radius, double angle_deg) {
    const double c = std::cos(angle_deg * std::numbers::pi / 180),
                 s = std::sin(angle_deg * std::numbers::pi / 180);
    Points x = mesh.rest;
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
        const double along = c * x(0, i) + s * x(2, i), across = -s * x(0, i) + c * x(2, i);
        const double arc = radius * std::sin(along / radius);
        x.col(i) = Vec3(c * arc - s * across, radius * (1 - std::cos(along / radius)), s * arc + c * across);
    }
    return x;
}

double rest_area(const Cloth& cloth) {
    return cloth.area.sum();
}

}  // namespace drape::test
