// Welding: file vertices that stand on the same rest position become one simulated vertex.
#pragma once

#include "mesh/mesh.h"

namespace drape {

// Triangles as a file has them, before any two of its vertices are known to be one.
struct TriangleSoup {
    Points positions;            // a column per vertex of the file [m]
    Faces faces;                 // indices of the file's vertices
    Eigen::Matrix2Xf corner_uv;  // column 3 f + c for corner c of triangle f; no columns: no UVs
};

struct WeldResult {
    Mesh mesh;
    int dropped_zero_area = 0;  // triangles left without area or with two corners in one place
    int unused_vertices = 0;    // vertices of the file on a place that no triangle uses
};

// Positions that are equal exactly are one vertex; a drawn vertex is one of those with one of its UVs.
// Vertices are numbered for locality, breadth first along the surface from one end of each piece
// (Cuthill and McKee 1969), triangles follow in that order; file_vertex keeps the file's order.
// If no triangle is left the mesh has no vertices either.
WeldResult weld(const TriangleSoup& soup);

// For each point the first one on exactly the same place.
std::vector<int> first_in_place(In points);

}  // namespace drape
