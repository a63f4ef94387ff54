#include "contact/sampling.h"

#include <array>
#include <map>

namespace drape {

namespace {

// A lattice point of a triangle is named by its corners and how many of the `level` parts each takes, sorted,
// so that the triangles on both sides of an edge name its points alike.
using Name = std::array<std::pair<int, int>, 3>;

Name name_of(const Eigen::Vector3i& face, int i, int j, int k) {
    Name name{{{face[0], i}, {face[1], j}, {face[2], k}}};
    for (auto& [vertex, parts] : name)
        if (parts == 0) vertex = -1;
    std::sort(name.begin(), name.end(), std::greater<>());
    return name;
}

ContactPoint point_of(const Model& model, const Cloth& cloth, const Name& name, int level) {
    ContactPoint point{};
    for (size_t k = 0; k < 3; ++k) {
        const auto [vertex, parts] = name[k];
        point.vertex[k] = cloth.first + (parts > 0 ? vertex : name[0].first);
        point.weight[k] = double(parts) / level;
        point.inverse_mass += point.weight[k] * point.weight[k] * model.inverse_mass[point.vertex[k]];
        point.corners += parts > 0;
    }
    return point;
}

}  // namespace

std::vector<ContactPoint> contact_points(const Model& model, const Cloth& cloth, int level) {
    std::map<Name, size_t> seen;
    std::vector<ContactPoint> points;
    const Mesh& mesh = cloth.mesh;
    for (int f = 0; f < mesh.triangles(); ++f) {
        const Eigen::Vector3i face = mesh.faces.col(f);
        const Vec3 a = mesh.rest.col(face[0]);
        const double area =
            (mesh.rest.col(face[1]) - a).cross(mesh.rest.col(face[2]) - a).norm() / 2 / (level * level);
        for (int i = 0; i <= level; ++i) {
            for (int j = 0; i + j <= level; ++j) {
                const int k = level - i - j;
                // of the small triangles around a lattice point, how many lie in this face: 1 at a corner, 3
                // on an edge, 6 inside; each gives a third of its area
                const int zeros = (i == 0) + (j == 0) + (k == 0);
                const double share = zeros == 2 ? 1 : zeros == 1 ? 3 : 6;
                const Name name = name_of(face, i, j, k);
                const auto [entry, fresh] = seen.try_emplace(name, points.size());
                if (fresh) points.push_back(point_of(model, cloth, name, level));
                points[entry->second].area += area * share / 3;
            }
        }
    }
    std::erase_if(points, [](const ContactPoint& point) { return point.inverse_mass == 0; });
    return points;
}

}  // namespace drape
