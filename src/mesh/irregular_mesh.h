// Sheets without rows: fixed points on borders and lines, Poisson-disk points between them, joined by their
// Delaunay triangulation.
#pragma once

#include <vector>

#include "mesh/mesh.h"
#include "mesh/poisson_disk.h"

namespace drape {

// Points from one place towards another, the first included and the last not, as far apart as the size field
// has it.
std::vector<Eigen::Vector2d> points_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                            const SizeField& edge_length);

// The same round a closed polygon.
std::vector<Eigen::Vector2d> points_round(const std::vector<Eigen::Vector2d>& corners,
                                          const SizeField& edge_length);

// A horizontal sheet, front side up, of the fixed points and what fits between them `inside`. Triangles whose
// centre is not inside are left out. x of the plane is x, its y is z; uv runs over the bounding box.
Mesh irregular_mesh(const std::vector<Eigen::Vector2d>& fixed, const Region& inside,
                    const SizeField& edge_length, std::uint64_t seed);

// The same of points and triangles, which turn left in the plane; vertices are put in order by strips [m].
Mesh flat_sheet(const Eigen::Matrix2Xd& points, const Faces& faces, double strip);

Eigen::Matrix2Xd columns_of(const std::vector<Eigen::Vector2d>& points);

}  // namespace drape
