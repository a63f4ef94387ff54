// Cusick's drape test: a disc of cloth 30 cm wide, clamped between two discs 18 cm wide, hangs over their
// rim. The drape coefficient is the share of the overhanging ring's area that its shadow from above covers.
#pragma once

#include <cstdint>

#include "cloth/fabric.h"
#include "mesh/mesh.h"

namespace drape {

inline constexpr double disc_radius = 0.15, support_radius = 0.09;  // [m]

struct CusickDrape {
    Mesh mesh;  // the ring, and a row of triangles between the discs
    Points x;
    double coefficient = 0;  // [-]
    int folds = 0;           // round the hem
    bool at_rest = false;
};

CusickDrape drape_disc(const Fabric& fabric, double edge, std::uint64_t seed = 1);

// The area that triangles cover, seen from above, on square cells [m^2].
double shadow_area(const Faces& faces, In x, double cell);

}  // namespace drape
