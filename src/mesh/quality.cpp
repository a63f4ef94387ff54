#include "mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace drape {

namespace {

constexpr double sharp_deg = 10, blunt_deg = 160;

void measure_edges(const Mesh& mesh, const Topology& topology, MeshQuality& quality) {
    if (topology.edges.empty()) return;
    quality.shortest_edge = std::numeric_limits<double>::infinity();
    double sum = 0;
    for (const Edge& edge : topology.edges) {
        const double length = (mesh.rest.col(edge.vertex[1]) - mesh.rest.col(edge.vertex[0])).norm();
        quality.shortest_edge = std::min(quality.shortest_edge, length);
        quality.longest_edge = std::max(quality.longest_edge, length);
        sum += length;
    }
    quality.mean_edge = sum / static_cast<double>(topology.edges.size());
}

}  // namespace

MeshQuality measure_quality(const Mesh& mesh, const Topology& topology) {
    MeshQuality quality;
    quality.vertices = mesh.vertices();
    quality.edges = static_cast<int>(topology.edges.size());
    quality.triangles = mesh.triangles();
    quality.components = topology.components;
    quality.boundary_loops = static_cast<int>(topology.boundary_loops.size());
    quality.non_manifold_edges = topology.non_manifold_edges;
    measure_edges(mesh, topology, quality);
    if (mesh.triangles() == 0) return quality;

    // shape of each triangle; what it adds to its corners' mass and stiffness
    quality.smallest_angle_deg = 180;
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(mesh.vertices()), stiffness = mass;
    for (int f = 0; f < mesh.triangles(); ++f) {
        const auto corner = [&](int c) { return Vec3(mesh.rest.col(mesh.faces(c % 3, f))); };
        const double twice_area = (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
        double sharpest = 180, bluntest = 0, longest = 0;
        for (int c = 0; c < 3; ++c) {
            const Vec3 left = corner(c + 1) - corner(c), right = corner(c + 2) - corner(c);
            const double angle = std::atan2(twice_area, left.dot(right)) * 180 / std::numbers::pi;
            const double opposite = (corner(c + 2) - corner(c + 1)).norm(), height = twice_area / opposite;
            sharpest = std::min(sharpest, angle);
            bluntest = std::max(bluntest, angle);
            longest = std::max(longest, opposite);
            mass[mesh.faces(c, f)] += twice_area / 6;
            stiffness[mesh.faces(c, f)] += twice_area / 2 / (height * height);
        }
        quality.area += twice_area / 2;
        quality.largest_aspect = std::max(quality.largest_aspect, longest * longest / twice_area);
        quality.slivers += sharpest < sharp_deg || bluntest > blunt_deg;
        if (sharpest < quality.smallest_angle_deg) {
            quality.smallest_angle_deg = sharpest;
            quality.worst_triangle = f;
        }
    }

    std::vector<double> ratio;
    for (int v = 0; v < mesh.vertices(); ++v)
        if (mass[v] > 0) ratio.push_back(stiffness[v] / mass[v]);
    const auto middle = ratio.begin() + static_cast<std::ptrdiff_t>(ratio.size() / 2);
    std::nth_element(ratio.begin(), middle, ratio.end());
    quality.step_cost = std::sqrt(*std::max_element(ratio.begin(), ratio.end()) / *middle);
    return quality;
}

}  // namespace drape
