// A mesh laid out in a plane.
#pragma once

#include "mesh/mesh.h"
#include "mesh/outline.h"

namespace drape {

struct FlatMesh {
    Eigen::Matrix2Xd place;  // of every vertex; triangles turn right, as seen from above where y points down
    Outline outline;         // its boundary
    bool level = false;      // the mesh is flat itself: its vertex at `place` stands at
    Vec3 origin = Vec3::Zero(), across = Vec3::UnitX(), down = Vec3::UnitZ();  // origin + x across + y down
};

// Throws Error for a mesh that has no sound place in a plane; see remesh.h.
FlatMesh flatten(const Mesh& mesh);

}  // namespace drape
