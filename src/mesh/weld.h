// Welding: drawn vertices that stand on the same rest position become one simulated vertex.
#pragma once

#include "mesh/mesh.h"

namespace drape {

struct WeldResult {
    Mesh mesh;
    int dropped_zero_area = 0;  // triangles left without area or with two corners in one place
    int unused_vertices = 0;    // vertices no triangle uses
};

// `positions`, `uv`, `faces` as a file has them, a column per file vertex (uv may have no columns).
// Positions that are equal exactly are one vertex. The result is numbered for locality: in order of first
// use along a breadth-first walk of the surface; file_vertex keeps the file's order.
WeldResult weld(const Points& positions, const Eigen::Matrix2Xf& uv, const Faces& faces);

}  // namespace drape
