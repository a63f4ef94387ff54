// Small cloths for tests.
#pragma once

#include <random>

#include "cloth/model.h"
#include "mesh/pattern.h"

namespace drape::test {

// The bare spring system of the lecture notes: springs of `stiffness` N/m along edges, nothing else.
Fabric bare_springs(double stiffness, double density = 0.2);

Mesh square(int divisions, std::string_view pattern = "alternating", double side = 1);

// The same sheet with its inner vertices shifted in its plane by up to `amount` of the spacing.
Mesh jittered_square(int divisions, std::string_view pattern, double amount);

// One equilateral triangle of side 1 in the x-z plane.
Mesh equilateral_triangle();

Points random_points(Eigen::Index count, double amount, unsigned seed);

Model model_of(Mesh mesh, const Fabric& fabric);

}  // namespace drape::test
