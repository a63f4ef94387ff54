// A cloth's elastic forces and nothing else: what virtual tests pull at.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "force/force.h"

namespace drape {

// A way for cloth to resist stretch, as a fabric says it.
struct Law {
    std::string name;
    Fabric fabric;
};

// A triangle in the plane y = 0, its base along x and centred on the origin; the apex, its last corner,
// stands above the place `along` the base, from 0 to 1, its height a share `above` of the base.
Mesh lone_triangle(double base, double along, double above);

// Patterns whose triangles are alike everywhere: all but `adaptive`.
std::vector<std::string> even_patterns();

// Of springs, altitudes, membrane and bending, those that the fabric has.
std::vector<std::unique_ptr<Force>> elastic_forces(const Cloth& cloth);

double energy_of(const std::vector<std::unique_ptr<Force>>& forces, In x);
Points forces_of(const std::vector<std::unique_ptr<Force>>& forces, In x);

// The stiffness matrix of a model's only cloth at a pose, of its free vertices.
BlockMatrix stiffness_of(const Model& model, In x);

// A cloth of this fabric that nothing holds.
Model free_cloth(Mesh mesh, const Fabric& fabric);

// Holds vertices of a model's first cloth where they rest.
void hold_at_rest(Model& model, const std::vector<int>& vertices);

}  // namespace drape
