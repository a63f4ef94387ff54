#include "integrate/dynamics.h"

#include <catch2/catch.hpp>

#include "support/motion.h"

using namespace drape;
using namespace drape::test;

namespace {

Fabric damped() {
    Fabric fabric = bare_springs(100);
    fabric.damping = 0.1;
    return fabric;
}

}  // namespace

TEST_CASE("acceleration is force over mass, and none where pinned", "[integrate]") {
    Model model = model_of(square(3), bare_springs(100));
    const Points x = model.cloths[0].mesh.rest + random_points(16, 0.05, 1);
    hold(model, {5}, x);
    Dynamics dynamics(model, forces_of(model, {}), nullptr);
    Points f = Points::Zero(3, 16), a;
    for (const ActiveForce& active : dynamics.forces()) active.force->add_conservative(x, f);
    dynamics.conservative_acceleration(x, 0, a);
    CHECK(a.col(5) == Vec3(0, 0, 0));
    for (int i = 0; i < 16; ++i)
        if (i != 5) CHECK((a.col(i) * model.mass[i] - f.col(i)).norm() < 1e-13);
    CHECK(dynamics.sweeps() == 1);
    for (const ActiveForce& active : dynamics.forces()) CHECK(active.calls == 1);
}

TEST_CASE("forces that sweep padded vertices add up with those that do not", "[integrate]") {
    // a second cloth, so that columns of the State are not numbers within a cloth
    Model model = model_of(square(3), damped());
    Fabric full = damped();
    full.altitude = AltitudeMode::blend;
    full.bending_kind = BendingKind::plate;
    full.bending = 0.1;
    add_cloth(model, make_cloth(jittered_square(5, "one_way", 0.2), full));
    Surroundings world;
    world.air = {.drag = 0.3, .aerodynamic = true, .wind = {2, 0, 1}};
    const Points x = random_points(model.vertices(), 0.5, 2), v = random_points(model.vertices(), 1, 3);
    Dynamics dynamics(model, forces_of(model, world), nullptr);
    Points still = Points::Zero(3, x.cols()), moving = still, a;
    double dissipated = 0;
    for (const ActiveForce& active : dynamics.forces()) {
        active.force->add_conservative(x, still);
        dissipated += active.force->add_all(x, v, 0.2, moving).dissipated;
    }
    const auto as_force = [&] { return Points(a * model.mass.asDiagonal()); };
    dynamics.conservative_acceleration(x, 0.2, a);
    CHECK((as_force() - still).norm() < 1e-13 * still.norm());
    dynamics.acceleration(x, v, 0.2, a);
    CHECK((as_force() - moving).norm() < 1e-13 * moving.norm());
    dynamics.book(1);
    CHECK(dynamics.flow().dissipated == Approx(dissipated).epsilon(1e-12));
    for (const ActiveForce& active : dynamics.forces()) CHECK(active.calls == 2);
}

TEST_CASE("energy is conserved unless something is damped, drags or moves by itself", "[integrate]") {
    const auto conservative = [](const Fabric& fabric, const Surroundings& world, const RigidMotion& motion) {
        Model model = model_of(square(2), fabric);
        hold(model, {0}, model.cloths[0].mesh.rest, motion);
        return Dynamics(model, forces_of(model, world), nullptr).is_conservative();
    };
    Surroundings drag;
    drag.air.drag = 0.1;
    CHECK(conservative(bare_springs(100), {}, {}));
    CHECK_FALSE(conservative(damped(), {}, {}));
    CHECK_FALSE(conservative(bare_springs(100), drag, {}));
    CHECK_FALSE(conservative(bare_springs(100), {}, carry(0, 1, {1, 0, 0})));
}

TEST_CASE("what a moving pin puts in is the force it needs times its speed", "[integrate]") {
    // all three corners are pins that rise: they carry the weight
    Model model = model_of(equilateral_triangle(), bare_springs(100));
    const Points x = model.cloths[0].mesh.rest;
    hold(model, {0, 1, 2}, x, carry(-1, 1, {0, 2, 0}));
    Dynamics dynamics(model, forces_of(model, {}), nullptr);
    State state{x, Points::Zero(3, 3), 0};
    place_pins(model, state);
    Points a;
    dynamics.acceleration(state.x, state.v, state.time, a);
    dynamics.book(2);
    const double speed = 1.5;  // halfway along a cubic from rest to rest
    CHECK(dynamics.flow().driven == Approx(2 * 9.81 * model.mass.sum() * speed));
    CHECK(dynamics.flow().dissipated == 0);
}
