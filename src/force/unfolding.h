// The neighbourhood of an edge laid out flat. Unfolding keeps lengths, so cloth that is curved at rest (a
// skirt) is taken as the flat panel it is cut from: fabric has no curvature of its own.
#pragma once

#include <vector>

#include "mesh/mesh.h"
#include "mesh/topology.h"

namespace drape {

class Unfolding {
public:
    struct Placed {
        int vertex;
        Eigen::Vector2d at;  // [m]
    };

    // The two triangles at an inner edge: its vertices first, then the corner opposite of each. The edge's
    // middle is the origin, the first axis runs along it, the second out of its first triangle.
    Unfolding(const Mesh& mesh, const Topology& topology, const Edge& edge);

    const std::vector<Placed>& points() const { return points_; }

    // Unfolds the triangles across the front's edges; false if there is none left.
    bool grow();

private:
    bool contains(int triangle) const;
    const Placed* find(int vertex) const;
    void place_far_corner(int face, int corner, int across);

    const Mesh& mesh_;
    const Topology& topology_;
    std::vector<int> front_, seen_;
    std::vector<Placed> points_;
};

}  // namespace drape
