// Small scenes to simulate.
#pragma once

#include "simulate/simulation.h"
#include "support/cloths.h"
#include "support/obstacles.h"
#include "support/pins.h"

namespace drape::test {

// A cloth at rest in its rest shape, held at some vertices: half a second at 20 frames a second.
Setup scene_of(Mesh mesh, const Fabric& fabric, const std::vector<int>& held = {},
               const RigidMotion& motion = {});

// The standard swatch (problems/README.md): bare springs, hung by two neighbouring corners of the square.
Setup swatch(int divisions, double stiffness);

// Springs along edges, altitudes blended, plates, everything damped.
Fabric full_fabric();

// A damped sheet in gusty wind and air drag, its two held corners swung round.
Setup flag(int divisions = 8);

Obstacle sphere(const Vec3& centre, double radius, double friction = 0);

// A damped sheet that falls on a rough ball below its middle.
Setup ball_drop(int divisions = 8);

// A sheet that falls past a ball at its side and touches nothing.
Setup near_miss();

// All frames, none of which may go wrong. Returns the largest speed of a vertex at any [m/s].
double run(Simulation& simulation);

}  // namespace drape::test
