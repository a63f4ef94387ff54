// Small scenes to simulate.
#pragma once

#include "simulate/simulation.h"
#include "support/cloths.h"
#include "support/obstacles.h"
#include "support/pins.h"

namespace drape::test {

// A cloth at rest in its rest shape, held at some vertices: half a second at 20 frames a second.
inline Setup scene_of(Mesh mesh, const Fabric& fabric, const std::vector<int>& held = {},
                      const RigidMotion& motion = {}) {
    Setup setup;
    setup.model = model_of(std::move(mesh), fabric);
    setup.start.x = setup.model.cloths[0].mesh.rest;
    setup.start.v = Points::Zero(3, setup.start.x.cols());
    if (!held.empty()) hold(setup.model, held, setup.start.x, motion);
    setup.frame_rate = 20;
    setup.frames = 10;
    return setup;
}

// The standard swatch (problems/README.md): bare springs, hung by two neighbouring corners of the square.
inline Setup swatch(int divisions, double stiffness) {
    return scene_of(square(divisions), bare_springs(stiffness), {0, divisions * (divisions + 1)});
}

// Springs along edges, altitudes blended, plates, everything damped.
inline Fabric full_fabric() {
    Fabric fabric = bare_springs(100);
    fabric.altitude = AltitudeMode::blend;
    fabric.bending_kind = BendingKind::plate;
    fabric.bending = 1e-3;
    fabric.damping = 0.05;
    return fabric;
}

// A damped sheet in gusty wind and air drag, its two held corners swung round.
inline Setup flag(int divisions = 8) {
    Setup setup = scene_of(square(divisions), full_fabric(), {0, divisions * (divisions + 1)},
                           carry(0, 0.4, {0.2, 0.1, 0.1}, {30, 40, 0}));
    setup.world.air = {.drag = 0.2, .aerodynamic = true, .wind = {2, 0, 1}, .gust_strength = 0.3};
    return setup;
}

inline Obstacle sphere(const Vec3& centre, double radius, double friction = 0) {
    ShapeParameters shape;
    shape.centre = centre;
    shape.radius = radius;
    return obstacle_of("sphere", shape, friction);
}

// A damped sheet that falls on a rough ball below its middle.
inline Setup ball_drop(int divisions = 8) {
    Setup setup = scene_of(square(divisions), full_fabric());
    setup.obstacles.push_back(sphere({0.02, -0.35, 0.01}, 0.3, 0.4));
    return setup;
}

// A sheet that falls past a ball at its side and touches nothing.
inline Setup near_miss() {
    Setup setup = scene_of(square(8), full_fabric());
    setup.obstacles.push_back(sphere({0.85, -0.3, 0}, 0.2));
    return setup;
}

// All frames, none of which may go wrong.
inline void run(Simulation& simulation) {
    while (simulation.frame() < simulation.frames())
        if (const FrameReport report = simulation.advance(); !report.trouble.empty())
            throw Error(report.trouble);
}

}  // namespace drape::test
