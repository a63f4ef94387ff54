// Cloth that hangs from its upper edge: how far its weight stretches it, and how it swings.
#pragma once

#include <vector>

#include "cloth/fabric.h"
#include "mesh/mesh.h"

namespace drape {

// A strip in the plane z = 0 that hangs from y = 0 down, of an alternating grid.
Mesh hanging_sheet(double width, double length, int columns, int rows);

// How far the lower edge has come down where all forces balance [m]; the upper edge is held.
double hanging_stretch(const Mesh& sheet, const Fabric& fabric, double gravity);

// Angular frequencies of small swings out of the plane, the slowest first, with every row of vertices moving
// as one [1/s].
std::vector<double> swing_frequencies(const Mesh& sheet, const Fabric& fabric, double gravity);

}  // namespace drape
