// Who is whose neighbour in a triangle mesh.
#pragma once

#include <array>
#include <vector>

#include "base/points.h"

namespace drape {

// An edge and the triangles on its two sides. Border edges have one, non-manifold edges more than two.
struct Edge {
    std::array<int, 2> vertex{};          // lower index first
    std::array<int, 2> face{-1, -1};      // the first two triangles that hold it; -1: none
    std::array<int, 2> opposite{-1, -1};  // the corner of each that is not on the edge
    int face_count = 0;
};

struct Topology {
    std::vector<Edge> edges;                       // sorted by (lower, higher) vertex
    Eigen::Matrix3Xi face_edges;                   // entry (c, f): the edge opposite corner c of triangle f
    std::vector<std::vector<int>> boundary_loops;  // vertices in order, longest loop first; where
                                                   // a non-manifold edge cuts one, an open chain
    std::vector<int> component;                    // per vertex; unused vertices get one of their own
    int components = 0;
    int non_manifold_edges = 0;
};

Topology build_topology(const Faces& faces, int vertices);

// The triangle across the edge opposite corner c of triangle f, or -1 at a border or non-manifold edge.
int neighbour_across(const Topology& topology, int face, int corner);

}  // namespace drape
