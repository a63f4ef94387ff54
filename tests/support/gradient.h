// Finite differences: what every force is held to.
#pragma once

#include <functional>

#include "base/points.h"

namespace drape::test {

// Minus the gradient of `energy` at x by central differences of fourth order.
Points minus_gradient(const std::function<double(In)>& energy, Points x, double h = 1e-4);

Vec3 net_force(In f);

Vec3 net_torque(In x, In f);

}  // namespace drape::test
