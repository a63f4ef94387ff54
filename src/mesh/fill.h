// Meshes that fill an outline to its border, or say that it is too narrow for them.
#pragma once

#include <functional>

#include "mesh/mesh.h"
#include "mesh/outline.h"

namespace drape {

// Puts points on the outline and has `make` mesh what they enclose, with a new point halfway wherever two
// neighbours came out unjoined. Throws Error where that does not help.
Mesh fill(const Outline& outline, const SizeField& edge_length,
          const std::function<Mesh(const std::vector<Loop>&)>& make);

// Poisson-disk points within an outline, joined by their Delaunay triangulation.
Mesh irregular_within(const Outline& outline, const SizeField& edge_length, std::uint64_t seed);

}  // namespace drape
