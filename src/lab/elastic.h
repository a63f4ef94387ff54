// A cloth's elastic forces and nothing else: what virtual tests pull at.
#pragma once

#include <memory>
#include <vector>

#include "force/force.h"

namespace drape {

// The model has one cloth. `forces` do not outlive it.
std::vector<std::unique_ptr<Force>> elastic_forces(const Cloth& cloth);

double energy_of(const std::vector<std::unique_ptr<Force>>& forces, In x);
Points forces_of(const std::vector<std::unique_ptr<Force>>& forces, In x);

// A cloth of this fabric that nothing holds.
Model free_cloth(Mesh mesh, const Fabric& fabric);

}  // namespace drape
