// A scene pays only for what it uses: what it does not need is not built and not called, and changes no bit.
#include <algorithm>
#include <catch2/catch.hpp>

#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

Points positions_after(const Setup& setup) {
    Simulation simulation(setup);
    run(simulation);
    return simulation.state().x;
}

}  // namespace

TEST_CASE("a stage the plan leaves out is not built, and a stage it uses is called at every sweep",
          "[simulate]") {
    for (const Setup& setup : {swatch(4, 200), flag(4), ball_drop(4)}) {
        Simulation simulation(setup);
        run(simulation);
        const std::vector<ActiveForce>& forces = simulation.dynamics().forces();
        size_t used = 0;
        for (const Stage& stage : simulation.plan().stages) {
            CAPTURE(stage.name, stage.because);
            CHECK_FALSE(stage.because.empty());
            if (stage.name.starts_with("contact")) {
                CHECK(stage.used == (simulation.dynamics().contact() != nullptr));
                continue;
            }
            const auto force = std::find_if(forces.begin(), forces.end(),
                                            [&](const ActiveForce& f) { return f.stage == stage.name; });
            CHECK(stage.used == (force != forces.end()));
            if (force == forces.end()) continue;
            CHECK(force->calls == simulation.dynamics().sweeps());
            ++used;
        }
        CHECK(used == forces.size());
    }
}

TEST_CASE("bare springs under gravity are two forces and nothing else", "[simulate]") {
    Simulation simulation(swatch(4, 200));
    const std::vector<ActiveForce>& forces = simulation.dynamics().forces();
    REQUIRE(forces.size() == 2);
    CHECK(forces[0].stage == "gravity");
    CHECK(forces[1].stage == "edge springs");
    CHECK(simulation.dynamics().contact() == nullptr);
    for (const char* stage : {"altitude springs", "membrane", "bending", "air drag", "wind", "contact"})
        CHECK_FALSE(simulation.plan().uses(stage));
    CHECK(simulation.advance().least_distance == INFINITY);
    CHECK(simulation.dynamics().contact_seconds() == 0);
}

TEST_CASE("an obstacle out of reach is left out and changes no bit", "[simulate]") {
    for (const Setup& without : {swatch(8, 200), flag(), ball_drop()}) {
        Setup with = without;
        with.obstacles.push_back(sphere({0, -500, 0}, 1));
        Simulation simulation(with);
        const Stage& stage = simulation.plan().stages.back();
        CHECK(stage.name == cat("contact with obstacle ", with.obstacles.size(), " (sphere)"));
        CHECK_FALSE(stage.used);
        CHECK(stage.because.starts_with("out of reach"));
        CHECK((simulation.dynamics().contact() == nullptr) == without.obstacles.empty());
        run(simulation);
        CHECK(simulation.state().x == positions_after(without));
    }
}

TEST_CASE("numbers of a fabric that nothing uses change no bit", "[simulate]") {
    const Setup plain = swatch(8, 200);
    Fabric fabric = bare_springs(200);
    fabric.altitude_ratio = 3;
    fabric.compressed_beyond = 0.1;
    fabric.bending_kind = BendingKind::plate;  // of no stiffness
    fabric.poisson = 0.4;
    fabric.thickness = 0.003;
    Setup other = plain;
    other.model = scene_of(square(8), fabric, {0, 72}).model;
    CHECK(positions_after(other) == positions_after(plain));
    other.model = scene_of(square(8), full_fabric(), {0, 72}).model;
    CHECK(positions_after(other) != positions_after(plain));
}

TEST_CASE("a second cloth that hangs apart changes no bit of the first at the same step", "[simulate]") {
    for (const char* method : {"verlet", "takahashi_imada"}) {
        Setup alone = swatch(8, 200);
        alone.method = method;
        alone.step = 0.001;
        Setup both = alone;
        Cloth second = make_cloth(square(3), bare_springs(50));
        add_cloth(both.model, second);
        both.start.x.conservativeResize(3, both.model.vertices());
        both.start.x.rightCols(16) = second.mesh.rest.colwise() + Vec3(3, 0, 0);
        both.start.v = Points::Zero(3, both.model.vertices());
        const Points together = positions_after(both);
        CHECK(together.leftCols(81) == positions_after(alone));
        CHECK(together(1, 90) < -1);  // it falls
    }
}

TEST_CASE("cloth thrown farther than was allowed for, past an obstacle left out, is trouble", "[simulate]") {
    // a net pressed into a fifth of its size: nothing about its start tells how far its springs throw it
    Setup setup = scene_of(square(4), bare_springs(200));
    setup.start.x *= 0.2;
    setup.world.gravity.setZero();
    setup.obstacles.push_back(sphere({0, 0.7, 0}, 0.1));
    Simulation simulation(setup);
    REQUIRE(simulation.dynamics().contact() == nullptr);
    FrameReport report = simulation.advance();
    while (report.trouble.empty() && simulation.frame() < simulation.frames()) report = simulation.advance();
    CHECK(report.trouble.find("where an obstacle was left out of contact") != std::string::npos);
    setup.obstacles.clear();
    Simulation free(setup);
    CHECK_NOTHROW(run(free));
}
