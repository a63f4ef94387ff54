// Sheets of finite elements for tests.
#pragma once

#include <string>
#include <vector>

#include "force/membrane.h"
#include "support/cloths.h"

namespace drape::test {

inline constexpr MembraneKind membrane_kinds[] = {MembraneKind::stvk, MembraneKind::neo_hookean};

// Finite elements of Y [N/m] and nothing else; springs of the same where `kind` is none.
Fabric membrane_fabric(MembraneKind kind, double modulus, double poisson = 0.3);

struct NamedPose {
    std::string name;
    Points x;
};

// A sheet stretched, squeezed, sheared, and with a vertex pushed through the edges opposite it, each turned
// in space and bent a little out of its plane.
std::vector<NamedPose> membrane_poses(const Mesh& mesh);

// A strip that hangs from its upper edge, x across, y up, its top at y = 0: `rows` times `columns` cells of a
// grid whose inner vertices are shifted by up to `jitter` of a cell.
Mesh hanging_strip(double width, double length, int columns, int rows, double jitter = 0);

}  // namespace drape::test
