#include "render/weave_coordinates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <tuple>

#include "mesh/topology.h"

namespace drape {

namespace {

// Metres that a unit of u and of v spans, averaged over the cloth by area.
Eigen::Vector2d metres_per_unit(const Mesh& mesh) {
    Eigen::Vector2d length = Eigen::Vector2d::Zero();
    double area_sum = 0;
    for (int f = 0; f < mesh.triangles(); ++f) {
        const Eigen::Vector3i corner = mesh.faces.col(f), drawn = mesh.drawn.faces.col(f);
        Eigen::Matrix<double, 3, 2> sides;
        sides << mesh.rest.col(corner[1]) - mesh.rest.col(corner[0]),
            mesh.rest.col(corner[2]) - mesh.rest.col(corner[0]);
        Eigen::Matrix2d in_uv;
        in_uv << (mesh.drawn.uv.col(drawn[1]) - mesh.drawn.uv.col(drawn[0])).cast<double>(),
            (mesh.drawn.uv.col(drawn[2]) - mesh.drawn.uv.col(drawn[0])).cast<double>();
        if (std::abs(in_uv.determinant()) < 1e-14) continue;
        const Eigen::Matrix<double, 3, 2> jacobian = sides * in_uv.inverse();
        const double area = Vec3(sides.col(0)).cross(Vec3(sides.col(1))).norm();
        length += area * Eigen::Vector2d(jacobian.col(0).norm(), jacobian.col(1).norm());
        area_sum += area;
    }
    return area_sum > 0 ? Eigen::Vector2d(length / area_sum) : Eigen::Vector2d::Zero();
}

// The axis each triangle faces most; one for all where nearly all of the area agrees.
std::vector<int> facing_axes(const Mesh& mesh) {
    std::vector<int> axes(static_cast<size_t>(mesh.triangles()));
    Vec3 area_of = Vec3::Zero();
    for (int f = 0; f < mesh.triangles(); ++f) {
        const Vec3 a = mesh.rest.col(mesh.faces(0, f)), b = mesh.rest.col(mesh.faces(1, f)),
                   c = mesh.rest.col(mesh.faces(2, f));
        const Vec3 area = (b - a).cross(c - a).cwiseAbs();
        area.maxCoeff(&axes[static_cast<size_t>(f)]);
        area_of[axes[static_cast<size_t>(f)]] += area.norm();
    }
    int main_axis = 0;
    if (area_of.maxCoeff(&main_axis) > 0.9 * area_of.sum()) axes.assign(axes.size(), main_axis);
    return axes;
}

DrawnMesh projected(const Mesh& mesh) {
    const std::vector<int> axes = facing_axes(mesh);
    DrawnMesh drawn;
    drawn.faces.resize(3, mesh.triangles());
    std::vector<Eigen::Vector2f> uv;
    std::map<std::pair<int, int>, int> made;  // (drawn vertex, axis) -> new drawn vertex
    for (int f = 0; f < mesh.triangles(); ++f) {
        const int axis = axes[static_cast<size_t>(f)];
        for (int c = 0; c < 3; ++c) {
            const int old = mesh.drawn.faces(c, f), vertex = mesh.faces(c, f);
            const auto [place, is_new] = made.try_emplace({old, axis}, static_cast<int>(drawn.vertex.size()));
            drawn.faces(c, f) = place->second;
            if (!is_new) continue;
            drawn.vertex.push_back(vertex);
            const Vec3 x = mesh.rest.col(vertex);
            uv.push_back(Eigen::Vector2d(x[axis == 0 ? 2 : 0], x[axis == 1 ? 2 : 1]).cast<float>());
        }
    }
    drawn.uv.resize(2, static_cast<Eigen::Index>(uv.size()));
    for (size_t i = 0; i < uv.size(); ++i) drawn.uv.col(static_cast<Eigen::Index>(i)) = uv[i];
    return drawn;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double length2 = (b - a).squaredNorm();
    const double t = length2 > 0 ? std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) : 0;
    return (p - (a + t * (b - a))).norm();
}

}  // namespace

DrawnMesh with_weave_coordinates(const Mesh& mesh) {
    if (mesh.drawn.uv.cols() == 0) return projected(mesh);
    const Eigen::Vector2d scale = metres_per_unit(mesh);
    if (scale.minCoeff() <= 0) return projected(mesh);
    DrawnMesh drawn = mesh.drawn;
    drawn.uv = scale.cast<float>().asDiagonal() * mesh.drawn.uv;
    return drawn;
}

Eigen::VectorXf border_distance(const Points& rest, const Faces& faces, float far) {
    const Topology topology = build_topology(faces, static_cast<int>(rest.cols()));
    std::vector<std::vector<int>> neighbours(static_cast<size_t>(rest.cols()));
    for (const Edge& edge : topology.edges)
        for (const int side : {0, 1})
            neighbours[static_cast<size_t>(edge.vertex[static_cast<size_t>(side)])].push_back(
                edge.vertex[static_cast<size_t>(1 - side)]);

    // as in Dijkstra's algorithm, but what spreads is the nearest border edge, measured straight
    struct Reached {
        double distance;
        int vertex, edge;
        bool operator>(const Reached& other) const {
            return std::tie(distance, vertex, edge) > std::tie(other.distance, other.vertex, other.edge);
        }
    };
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
    std::vector<double> distance(static_cast<size_t>(rest.cols()), std::numeric_limits<double>::infinity());
    const auto reach = [&](int vertex, int e) {
        const auto& ends = topology.edges[static_cast<size_t>(e)].vertex;
        const double d = distance_to_segment(rest.col(vertex), rest.col(ends[0]), rest.col(ends[1]));
        if (d >= distance[static_cast<size_t>(vertex)]) return;
        distance[static_cast<size_t>(vertex)] = d;
        front.push({d, vertex, e});
    };
    for (int e = 0; e < static_cast<int>(topology.edges.size()); ++e)
        if (topology.edges[static_cast<size_t>(e)].face_count == 1)
            for (const int end : topology.edges[static_cast<size_t>(e)].vertex) reach(end, e);
    while (!front.empty()) {
        const Reached next = front.top();
        front.pop();
        if (next.distance > distance[static_cast<size_t>(next.vertex)]) continue;
        for (const int neighbour : neighbours[static_cast<size_t>(next.vertex)]) reach(neighbour, next.edge);
    }

    Eigen::VectorXf result(rest.cols());
    for (int v = 0; v < rest.cols(); ++v)
        result[v] = std::min(static_cast<float>(distance[static_cast<size_t>(v)]), far);
    return result;
}

}  // namespace drape
