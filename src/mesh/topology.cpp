#include "mesh/topology.h"

#include <algorithm>
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
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& s, const Side& t) { return s.a != t.a ? s.a < t.a : s.b < t.b; });
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

// The border edge that follows `edge` at its end `vertex`: turns about the vertex from triangle to triangle
// until a side has no other one, so that loops that touch in a vertex stay apart and orientation does not
// matter. -1: a non-manifold edge is in the way.
int next_border(const Topology& topology, const Faces& faces, int edge, int vertex) {
    int face = topology.edges[static_cast<size_t>(edge)].face[0];
    for (;;) {
        for (int c = 0; c < 3; ++c) {
            if (faces(c, face) == vertex || topology.face_edges(c, face) == edge) continue;
            edge = topology.face_edges(c, face);
            break;
        }
        const Edge& side = topology.edges[static_cast<size_t>(edge)];
        if (side.face_count != 2) return side.face_count == 1 ? edge : -1;
        face = side.face[0] == face ? side.face[1] : side.face[0];
    }
}

// Walks along border edges from `edge` towards `vertex` and lists the vertices met. True: back at the start.
bool walk_border(const Topology& topology, const Faces& faces, int edge, int vertex,
                 std::vector<bool>& walked, std::vector<int>& met) {
    for (const int first = edge; edge >= 0;) {
        walked[static_cast<size_t>(edge)] = true;
        met.push_back(vertex);
        edge = next_border(topology, faces, edge, vertex);
        if (edge == first) return true;
        if (edge < 0) break;
        const auto& ends = topology.edges[static_cast<size_t>(edge)].vertex;
        vertex = ends[0] == vertex ? ends[1] : ends[0];
    }
    return false;
}

// Loops run in the direction of their first edge's triangle. One that a non-manifold edge cuts is an open
// chain.
void trace_boundary(Topology& topology, const Faces& faces) {
    std::vector<bool> walked(topology.edges.size(), false);
    for (size_t e = 0; e < topology.edges.size(); ++e) {
        const Edge& edge = topology.edges[e];
        if (edge.face_count != 1 || walked[e]) continue;
        const auto face = faces.col(edge.face[0]);
        const int after_opposite = face[0] == edge.opposite[0] ? 1 : face[1] == edge.opposite[0] ? 2 : 0;
        const int from = face[after_opposite], to = face[(after_opposite + 1) % 3];
        std::vector<int> loop;
        if (!walk_border(topology, faces, static_cast<int>(e), to, walked, loop)) {
            std::vector<int> before;
            walk_border(topology, faces, static_cast<int>(e), from, walked, before);
            loop.insert(loop.begin(), before.rbegin(), before.rend());
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
