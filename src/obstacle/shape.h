// What a scene says about an obstacle's form: a kind's name and its numbers.
#pragma once

#include "base/points.h"

namespace drape {

// Every number any kind of obstacle takes; each kind reads its own (obstacle.cpp's table says which).
// All lengths in metres, in the obstacle's own frame before `motion`.
struct ShapeParameters {
    Vec3 centre = Vec3::Zero();
    Vec3 normal = Vec3::UnitY();  // plane
    Vec3 axis = Vec3::UnitY();    // cylinder, torus
    Vec3 from = Vec3::Zero();     // capsule: its two end points
    Vec3 to = Vec3::UnitY();
    Vec3 size = Vec3::Ones();        // box: full edge lengths
    Vec3 rotate_deg = Vec3::Zero();  // box: about x, then y, then z
    double radius = 0.1;             // sphere, capsule, cylinder; torus: of the ring
    double tube_radius = 0.05;       // torus
    double height = 1;               // cylinder, from cap to cap
    double rounding = 0;             // box, cylinder: radius of its edges, within the given size
};

}  // namespace drape
