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

// Nearer than this part of its radius to an axis, a direction away from the axis is only rounding error.
inline constexpr double round_off = 1e-9;

// The unit vector along `v`. Throws Error if v is zero.
Vec3 require_direction(std::string_view what, const Vec3& v);

// How deep a triangle with sides <= spacing, its corners on a surface of this radius of curvature, dips below
// it [m]: r - sqrt(r^2 - a^2) with the largest circumradius a = spacing / sqrt 3; at most r.
double round_sagitta(double radius, double spacing);

// The same for a solid with rounded edges, given how deep the triangle would dip into its sharp form. The
// round lies up to (1 - 1/sqrt 3) of its radius inside that form; well within the round only it counts.
double edge_sagitta(double sharp, double rounding, double spacing);

}  // namespace drape
