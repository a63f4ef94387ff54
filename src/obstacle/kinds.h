// The makers of every kind of solid, for the table in obstacle.cpp, and what they share.
#pragma once

#include <memory>
#include <string_view>

#include "obstacle/obstacle.h"

namespace drape {

std::unique_ptr<Solid> make_plane(const ShapeParameters&);
std::unique_ptr<Solid> make_sphere(const ShapeParameters&);
std::unique_ptr<Solid> make_capsule(const ShapeParameters&);
std::unique_ptr<Solid> make_box(const ShapeParameters&);
std::unique_ptr<Solid> make_cylinder(const ShapeParameters&);
std::unique_ptr<Solid> make_torus(const ShapeParameters&);

// Throws Error "radius must be positive, got -1 m".
void require_positive(std::string_view what, double value);

// The unit vector along `v`. Throws Error if v is zero.
Vec3 require_direction(std::string_view what, const Vec3& v);

// How deep a triangle with sides <= spacing, its corners on a surface of this radius of curvature, dips below
// it [m]: r - sqrt(r^2 - a^2) with the largest circumradius a = spacing / sqrt 3; at most r.
double round_sagitta(double radius, double spacing);

// The same across a sharp right-angled edge: the middle of a chord of length s is s / (2 sqrt 2) deep.
double edge_sagitta(double rounding, double spacing);

}  // namespace drape
