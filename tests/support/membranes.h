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

}  // namespace drape::test
