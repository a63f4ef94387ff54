// The surface that is drawn where the simulated mesh is coarse: each triangle in four, once or twice.
//
// An edge a-b gets its middle from the cubic that leaves both ends along their tangent planes,
//   m = (a + b)/2 + ((d.nb) nb - (d.na) na)/8,   d = b - a,   na, nb: vertex normals
// (the edge rule of PN triangles, Vlachos et al. 2001, at its middle). It interpolates: the simulated
// vertices stay where contact left them and their chords swell outwards over an obstacle, where an
// approximating scheme such as Loop's would shrink into it. It reaches no farther than an edge, so odd
// valences make no ripples.
// A border edge follows the curve of the border instead: tangents (b - before)/2 and (after - a)/2 in the
// same cubic, straight into corners.
//
// Layers that lie on each other would swell through each other: a middle leaves its chord by no more than a
// fifth of what room its ends have at each level, so that the two of them keep a fifth of it.
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh.h"

namespace drape {

// All that does not change from frame to frame.
class SmoothSurface {
public:
    // `drawn` sits on the vertices of `mesh`; its uv are carried along linearly.
    SmoothSurface(const Mesh& mesh, const DrawnMesh& drawn, int levels);

    // Positions of all vertices, the simulated ones first. `room`: how far each simulated vertex's triangles
    // are from others that they may not cross [m]; empty: far.
    Points positions(In simulated, const Eigen::VectorXd& room = {}) const;
    const Faces& faces() const { return faces_.back(); }
    const Points& rest() const { return rest_; }       // flat: middles of rest edges
    const DrawnMesh& drawn() const { return drawn_; }  // its `vertex` and `faces` at the finest level
    // The simulated edges as chains of short ones: pairs of vertices.
    const std::vector<std::array<int, 2>>& simulated_edges() const { return simulated_edges_; }
    // Per vertex, carried along linearly from the simulated ones.
    Eigen::VectorXf spread(const Eigen::VectorXf& simulated) const;

private:
    // A new vertex in the middle of edge a-b.
    struct Middle {
        int a, b;
        bool border = false;
        int before = -1, after = -1;  // on a border: its vertices beside a and b, -1 past a corner
    };

    void refine();

    std::vector<Faces> faces_;                  // per level, the coarsest first
    std::vector<std::vector<Middle>> middles_;  // per level
    DrawnMesh drawn_;
    Points rest_;
    std::vector<std::array<int, 2>> simulated_edges_;
};

// Levels that bring a mesh near 20 000 triangles, at most two.
int smoothing_levels(int triangles);

}  // namespace drape
