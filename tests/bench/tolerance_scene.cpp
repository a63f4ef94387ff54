#include "bench/tolerance_scene.h"

#include <array>
#include <cmath>

#include "support/setups.h"

namespace drape::bench {

namespace {

constexpr std::array scenes{
    // bare springs, which conserve energy
    ToleranceScene{.name = "swatch 9", .side = 9, .stiffness = 50, .duration = 1, .tolerance = 1e-5},
    ToleranceScene{.name = "stiff swatch 9", .side = 9, .stiffness = 50000},
    ToleranceScene{.name = "swatch 17", .side = 17, .tolerance = 1e-4},
    ToleranceScene{.name = "swatch 33", .tolerance = 1e-4},
    ToleranceScene{.name = "swatch 33, tight", .duration = 0.3, .tolerance = 1e-5},
    ToleranceScene{.name = "stiff swatch 33", .stiffness = 50000, .duration = 0.2, .tolerance = 1e-2},
    ToleranceScene{
        .name = "stiff swatch 65", .side = 65, .stiffness = 50000, .duration = 0.2, .tolerance = 1e-2},
    ToleranceScene{.name = "swatch 129", .side = 129, .duration = 0.2},
    // more springs
    ToleranceScene{.name = "plates 33",
                   .stiffness = 5000,
                   .tolerance = 1e-4,
                   .bending_kind = BendingKind::plate,
                   .bending = 1e-3},
    ToleranceScene{.name = "blend 17", .side = 17, .stiffness = 2000, .altitude = AltitudeMode::blend},
    ToleranceScene{.name = "shortest altitude 17",
                   .side = 17,
                   .tolerance = 1e-4,
                   .damping = 0.05,
                   .altitude = AltitudeMode::shortest},
    // damping and air
    ToleranceScene{.name = "damped 33", .stiffness = 5000, .damping = 0.05},
    ToleranceScene{.name = "syrup 17", .side = 17, .duration = 1, .tolerance = 1e-5, .damping = 0.5},
    ToleranceScene{.name = "hinges in drag 17",
                   .side = 17,
                   .stiffness = 1000,
                   .tolerance = 1e-4,
                   .bending_kind = BendingKind::hinge,
                   .bending = 1e-4,
                   .drag = 0.3},
    ToleranceScene{.name = "flag 33",
                   .stiffness = 1000,
                   .damping = 0.05,
                   .bending_kind = BendingKind::plate,
                   .bending = 1e-4,
                   .altitude = AltitudeMode::blend,
                   .held = Held::edge,
                   .wind = 4,
                   .gust = 0.3},
    ToleranceScene{.name = "carried 17",
                   .side = 17,
                   .duration = 0.6,
                   .tolerance = 1e-4,
                   .damping = 0.02,
                   .bending_kind = BendingKind::plate,
                   .bending = 1e-4,
                   .held = Held::carried},
    // contact
    ToleranceScene{.name = "smooth ball 17",
                   .side = 17,
                   .damping = 0.05,
                   .bending_kind = BendingKind::plate,
                   .bending = 1e-3,
                   .held = Held::nowhere,
                   .obstacle = "sphere"},
    ToleranceScene{.name = "rough ball 33",
                   .duration = 0.6,
                   .damping = 0.1,
                   .bending_kind = BendingKind::plate,
                   .bending = 1e-3,
                   .held = Held::nowhere,
                   .obstacle = "sphere",
                   .friction = 0.4},
    ToleranceScene{.name = "stiff on ball 33",
                   .stiffness = 20000,
                   .duration = 0.4,
                   .tolerance = 1e-2,
                   .damping = 0.05,
                   .bending_kind = BendingKind::plate,
                   .bending = 1e-3,
                   .altitude = AltitudeMode::blend,
                   .held = Held::nowhere,
                   .obstacle = "sphere",
                   .friction = 0.3},
    ToleranceScene{.name = "hem on the ground 17",
                   .side = 17,
                   .stiffness = 2000,
                   .damping = 0.1,
                   .bending_kind = BendingKind::plate,
                   .bending = 1e-3,
                   .obstacle = "plane",
                   .friction = 0.3},
};

Fabric fabric_of(const ToleranceScene& scene) {
    Fabric fabric = test::bare_springs(scene.stiffness);
    fabric.damping = scene.damping;
    fabric.bending_kind = scene.bending_kind;
    fabric.bending = scene.bending;
    fabric.altitude = scene.altitude;
    return fabric;
}

std::vector<int> held_by(const ToleranceScene& scene) {
    const int last = scene.side * (scene.side - 1);
    if (scene.held == Held::nowhere) return {};
    if (scene.held != Held::edge) return {0, last};
    std::vector<int> edge;
    for (int i = 0; i <= last; i += scene.side) edge.push_back(i);
    return edge;
}

ShapeParameters shape_of(const ToleranceScene& scene) {
    ShapeParameters shape;
    if (std::string_view(scene.obstacle) == "sphere") {
        shape.centre = {0.02, -0.35, 0.01};
        shape.radius = 0.3;
    } else {
        shape.centre = {0, -0.4, 0};
    }
    return shape;
}

}  // namespace

std::span<const ToleranceScene> tolerance_scenes() {
    return scenes;
}

Setup setup_of(const ToleranceScene& scene) {
    const RigidMotion motion =
        scene.held == Held::carried ? test::carry(0, 0.4, {0.2, 0.1, 0.1}, {30, 40, 0}) : RigidMotion{};
    Setup setup = test::scene_of(test::square(scene.side - 1), fabric_of(scene), held_by(scene), motion);
    setup.frames = static_cast<int>(std::lround(scene.duration * setup.frame_rate));
    setup.world.air.drag = scene.drag;
    if (scene.wind > 0) {
        setup.world.air.aerodynamic = true;
        setup.world.air.wind = {scene.wind, 0, scene.wind / 4};
        setup.world.air.gust_strength = scene.gust;
    }
    if (*scene.obstacle)
        setup.obstacles.push_back(test::obstacle_of(scene.obstacle, shape_of(scene), scene.friction));
    return setup;
}

}  // namespace drape::bench
