#include "support/setups.h"

#include <algorithm>

namespace drape::test {

Setup scene_of(Mesh mesh, const Fabric& fabric, const std::vector<int>& held, const RigidMotion& motion) {
    Setup setup;
    setup.model = model_of(std::move(mesh), fabric);
    setup.start.x = setup.model.cloths[0].mesh.rest;
    setup.start.v = Points::Zero(3, setup.start.x.cols());
    if (!held.empty()) hold(setup.model, held, setup.start.x, motion);
    setup.frame_rate = 20;
    setup.frames = 10;
    return setup;
}

Setup swatch(int divisions, double stiffness) {
    return scene_of(square(divisions), bare_springs(stiffness), {0, divisions * (divisions + 1)});
}

Fabric full_fabric() {
    Fabric fabric = bare_springs(100);
    fabric.altitude = AltitudeMode::blend;
    fabric.bending_kind = BendingKind::plate;
    fabric.bending = 1e-3;
    fabric.damping = 0.05;
    return fabric;
}

Setup flag(int divisions) {
    Setup setup = scene_of(square(divisions), full_fabric(), {0, divisions * (divisions + 1)},
                           carry(0, 0.4, {0.2, 0.1, 0.1}, {30, 40, 0}));
    setup.world.air = {.drag = 0.2, .aerodynamic = true, .wind = {2, 0, 1}, .gust_strength = 0.3};
    return setup;
}

Obstacle sphere(const Vec3& centre, double radius, double friction) {
    ShapeParameters shape;
    shape.centre = centre;
    shape.radius = radius;
    return obstacle_of("sphere", shape, friction);
}

Setup ball_drop(int divisions) {
    Setup setup = scene_of(square(divisions), full_fabric());
    setup.obstacles.push_back(sphere({0.02, -0.35, 0.01}, 0.3, 0.4));
    return setup;
}

Setup near_miss() {
    Setup setup = scene_of(square(8), full_fabric());
    setup.obstacles.push_back(sphere({0.85, -0.3, 0}, 0.2));
    return setup;
}

double run(Simulation& simulation) {
    double fastest = 0;
    while (simulation.frame() < simulation.frames()) {
        const FrameReport report = simulation.advance();
        if (!report.trouble.empty()) throw Error(report.trouble);
        fastest = std::max(fastest, report.fastest);
    }
    return fastest;
}

}  // namespace drape::test
