// One force by its name, and what it does at a pose.
#pragma once

#include <memory>
#include <string_view>

#include "force/force.h"

namespace drape::test {

// null: the cloth or its surroundings have no use for it
std::unique_ptr<Force> make_force(std::string_view name, const Cloth& cloth, const Surroundings& world = {});

Points force_at(const Force& force, In x);

Points force_at(const Force& force, In x, In v, double time = 0);

// The largest eigenvalue of the stiffness -df/dx at x, by central differences [N/m].
double largest_stiffness(const Force& force, const Points& x);

double largest_bound(const Force& force, In x);

}  // namespace drape::test
