// A triangle mesh in two views of one surface: what is simulated and what is drawn.
#pragma once

#include <vector>

#include "base/points.h"

namespace drape {

// The drawing's view: where a UV seam runs, one simulated vertex is several drawn ones.
struct DrawnMesh {
    std::vector<int> vertex;  // for each drawn vertex the simulated vertex it sits on
    Eigen::Matrix2Xf uv;      // a column per drawn vertex; no columns if the mesh has no UVs
    Faces faces;              // indices of drawn vertices; column f is the same triangle as Mesh::faces column f
};

struct Mesh {
    Points rest;   // 3 x V positions at rest [m], no two alike: a seam's twins are one vertex
    Faces faces;   // 3 x F, each with three distinct corners and an area above zero
    DrawnMesh drawn;
    std::vector<int> file_vertex;  // for each vertex of the file, in the file's order, its vertex here

    int vertices() const { return static_cast<int>(rest.cols()); }
    int triangles() const { return static_cast<int>(faces.cols()); }
};

// A mesh whose drawn vertices are its simulated ones, in file order as they stand; uv may have no columns.
Mesh plain_mesh(Points rest, Faces faces, Eigen::Matrix2Xf uv = {});

}  // namespace drape
