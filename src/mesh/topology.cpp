#include "mesh/topology.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace drape {

namespace {

struct Side {
    int a, b, face, corner;  // a < b
};

std::vector<Side> sorted_sides(const Faces& faces) {
    std::vector<Side> sides;
    sides.reserve(static_cast<size_t>(faces.cols()) * 3);
    for (int f = 0; f < faces.cols(); ++f) {
        for (int c = 0; c < 3; ++c) {
            const auto [low, high] = std::minmax(faces((c + 1) % 3, f), faces((c + 2) % 3, f));
            sides.push_back({low, high, f, c});
        }
    }
    std::stable_sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
        return s.a != t.a ? s.a < t.a : s.b < t.b;
    });
    return sides;
}

int root_of(std::vector<int>& parent, int i) {
    while (parent[static_cast<size_t>(i)] != i) {
        parent[static_cast<size_t>(i)] = parent[static_cast<size_t>(parent[static_cast<size_t>(i)])];
        i = parent[static_cast<size_t>(i)];
    }
    return i;
}

// Numbers the connected pieces in the order of their first vertex.
void label_components(Topology& topology, int vertices) {
    std::vector<int> parent(static_cast<size_t>(vertices));
    std::iota(parent.begin(), parent.end(), 0);
    for (const Edge& edge : topology.edges) {
        const int a = root_of(parent, edge.vertex[0]), b = root_of(parent, edge.vertex[1]);
        parent[static_cast<size_t>(std::max(a, b))] = std::min(a, b);
    }
    topology.component.assign(static_cast<size_t>(vertices), -1);
    for (int v = 0; v < vertices; ++v) {
        int& root_label = topology.component[static_cast<size_t>(root_of(parent, v))];
        if (root_label < 0) root_label = topology.components++;
        topology.component[static_cast<size_t>(v)] = root_label;
    }
}

// Walks border edges in the direction of their triangle; where loops touch in a vertex they are walked in turn.
void trace_boundary(Topology& topology, const Faces& faces) {
    std::map<int, std::vector<int>> next;  // from -> to, along border half-edges
    for (const Edge& edge : topology.edges) {
        if (edge.face_count != 1) continue;
        const auto face = faces.col(edge.face[0]);
        for (int c = 0; c < 3; ++c)
            if (face[c] == edge.opposite[0]) next[face[(c + 1) % 3]].push_back(face[(c + 2) % 3]);
    }
    while (!next.empty()) {
        std::vector<int> loop;
        int at = next.begin()->first;
        for (auto step = next.find(at); step != next.end(); step = next.find(at)) {
            loop.push_back(at);
            at = step->second.back();
            step->second.pop_back();
            if (step->second.empty()) next.erase(step);
        }
        topology.boundary_loops.push_back(std::move(loop));
    }
    std::stable_sort(topology.boundary_loops.begin(), topology.boundary_loops.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
}

}  // namespace

Topology build_topology(const Faces& faces, int vertices) {
    Topology topology;
    topology.face_edges.resize(3, faces.cols());
    for (const Side& side : sorted_sides(faces)) {
        const std::array<int, 2> ends{side.a, side.b};
        if (topology.edges.empty() || topology.edges.back().vertex != ends)
            topology.edges.push_back({.vertex = ends});
        Edge& edge = topology.edges.back();
        if (edge.face_count < 2) {
            const auto slot = static_cast<size_t>(edge.face_count);
            edge.face[slot] = side.face;
            edge.opposite[slot] = faces(side.corner, side.face);
        }
        ++edge.face_count;
        topology.face_edges(side.corner, side.face) = static_cast<int>(topology.edges.size()) - 1;
    }
    for (const Edge& edge : topology.edges) topology.non_manifold_edges += edge.face_count > 2;
    label_components(topology, vertices);
    trace_boundary(topology, faces);
    return topology;
}

int neighbour_across(const Topology& topology, int face, int corner) {
    const Edge& edge = topology.edges[static_cast<size_t>(topology.face_edges(corner, face))];
    if (edge.face_count != 2) return -1;
    return edge.face[0] == face ? edge.face[1] : edge.face[0];
}

}  // namespace drape
