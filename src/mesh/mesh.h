// A triangle mesh in two views of one surface: what is simulated and what is drawn.
#pragma once

#include <vector>

#include "base/points.h"

namespace drape {

// The drawing's view: where a UV seam runs, one simulated vertex is several drawn ones.
struct DrawnMesh {
    std::vector<int> vertex;  // for each drawn vertex the simulated vertex it sits on
    Eigen::Matrix2Xf uv;      // a column per drawn vertex; no columns if the mesh has no UVs
    Faces faces;  // indices of drawn vertices; column f is the same triangle as Mesh::faces column f
};

struct Mesh {
    Points rest;  // 3 x V positions at rest [m], no two alike: a seam's twins are one vertex
    Faces faces;  // 3 x F, each with three distinct corners and an area above zero
    DrawnMesh drawn;
    // for each vertex of the file, in the file's order, its vertex here; -1: no triangle uses it, so it is
    // not simulated and stands still
    std::vector<int> file_vertex;
    Points unused;  // where the vertices with file_vertex -1 stand, in file order [m]

    int vertices() const { return static_cast<int>(rest.cols()); }
    int triangles() const { return static_cast<int>(faces.cols()); }
};

// A mesh whose drawn vertices are its simulated ones, in file order as they stand; uv may have no columns.
Mesh plain_mesh(Points rest, Faces faces, Eigen::Matrix2Xf uv = {});

// Positions of the simulated vertices spread over the file's vertices: what a file for other programs holds.
Points in_file_order(const Mesh& mesh, In positions);

}  // namespace drape
