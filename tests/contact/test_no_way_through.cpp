// Whole simulations: whatever the speed, and however coarse the cloth, it stays outside.
#include <catch2/catch.hpp>

#include "support/touching.h"

using namespace drape;
using namespace drape::test;

namespace {

// The least distance at any frame, by drape's report and by a lattice of our own.
double least_distance(Simulation& simulation, const Obstacle& obstacle) {
    double least = INFINITY;
    const Faces faces = simulation.model().cloths[0].mesh.faces;
    while (simulation.frame() < simulation.frames()) {
        const FrameReport report = simulation.advance();
        REQUIRE(report.trouble == "");
        const double seen = lattice_distance(faces, simulation.state().x, obstacle, simulation.state().time);
        least = std::min({least, report.least_distance, seen});
    }
    return least;
}

ShapeParameters shape_on_tip() {
    ShapeParameters shape;  // a box standing on one corner, another one straight up
    shape.size.setConstant(0.6);
    shape.rotate_deg = Vec3(45, 0, 180 / std::numbers::pi * std::atan(1 / std::numbers::sqrt2));
    return shape;
}

}  // namespace

TEST_CASE("a cloth hitting a plane or a thin box at 50 m/s does not get through", "[contact]") {
    ShapeParameters thin;
    thin.size = Vec3(2, 0.004, 2);
    for (const Obstacle& obstacle : {obstacle_of("plane", {}, 0.3), obstacle_of("box", thin, 0.3)}) {
        for (const double tilt : {0.0, 0.5}) {
            CAPTURE(obstacle.kind, tilt);
            Setup setup =
                setup_of(raised(square(8, "alternating", 0.5), 0.6), bare_springs(200), {obstacle}, 200, 20);
            setup.start.x.row(1) += tilt * setup.start.x.row(0);
            setup.start.v.row(1).setConstant(-50);
            Simulation simulation(std::move(setup));
            const double least = least_distance(simulation, obstacle);
            CHECK(least > 0);
            CHECK(simulation.state().v.row(1).maxCoeff() > -5);  // it was stopped
        }
    }
}

TEST_CASE("a ball shot at a cloth at 100 m/s does not get through", "[contact]") {
    ShapeParameters ball;
    ball.radius = 0.1;
    const RigidMotion shot({{0, Vec3(0, -1.4, 0)}, {0.042, Vec3(0, 1.4, 0)}});
    REQUIRE(shot.at(0.021).linear.y() == Approx(100));
    const Obstacle obstacle = obstacle_of("sphere", ball, 0.3, shot);
    Setup setup = setup_of(square(8, "alternating", 0.5), bare_springs(2000), {obstacle}, 500, 21);
    setup.world.gravity.setZero();
    Simulation simulation(std::move(setup));
    const double least = least_distance(simulation, obstacle);
    CHECK(least > 0);
    CHECK(simulation.state().x.row(1).mean() > 0.5);  // it was carried along
}

TEST_CASE("a ball that is past a cloth within one step takes it along all the same", "[contact]") {
    ShapeParameters ball;
    ball.radius = 0.1;
    // 2.2 m from rest to rest, in less than a step of a frame
    for (const double seconds : {0.002, 0.02}) {
        for (const std::string method : {"verlet", "xpbd", "backward_euler", "tr_bdf2"}) {
            const RigidMotion shot({{0, Vec3(0, -1.1, 0)}, {seconds, Vec3(0, 1.1, 0)}});
            const Obstacle obstacle = obstacle_of("sphere", ball, 0.3, shot);
            Setup setup = setup_of(square(6, "alternating", 0.5), bare_springs(0.5), {obstacle}, 30, 1);
            setup.world.gravity.setZero();
            setup.method = method;
            setup.step = 1.0 / 30;
            Simulation simulation(std::move(setup));
            CAPTURE(seconds, method);
            CHECK(least_distance(simulation, obstacle) > 0);
            CHECK(simulation.state().x.row(1).maxCoeff() > 1.1);
        }
    }
}

TEST_CASE("no triangle of a coarse cloth pokes through an obstacle's edges, corners or bends", "[contact]") {
    ShapeParameters edge, rod;
    edge.size = Vec3(0.5, 0.5, 2);
    edge.rotate_deg = Vec3(0, 0, 45);
    rod.axis = Vec3(0.1, 1, 0);
    rod.radius = 0.15;
    rod.tube_radius = 0.08;
    for (const Obstacle& obstacle : {obstacle_of("box", shape_on_tip(), 0.3), obstacle_of("box", edge, 0.3),
                                     obstacle_of("cylinder", rod, 0.3), obstacle_of("torus", rod, 0.3)}) {
        CAPTURE(obstacle.kind, obstacle.solid->reach());
        Fabric fabric = bare_springs(100);
        fabric.damping = 0.05;
        Simulation simulation(
            setup_of(raised(square(5, "alternating", 1.2), 0.7), fabric, {obstacle}, 30, 30));
        const double least = least_distance(simulation, obstacle);
        CHECK(least > 0);
        CHECK(simulation.flow().dissipated > 0);
        CHECK(simulation.state().x.row(1).minCoeff() < 0.5);  // it hangs over
    }
}

TEST_CASE("cloth stretched over an obstacle until its contact points lie too far apart stops the run",
          "[contact]") {
    ShapeParameters ball;
    ball.radius = 0.2;
    const Obstacle obstacle = obstacle_of("sphere", ball, 0.3);
    Fabric fabric = bare_springs(260, 0.15);
    fabric.damping = 0.05;
    Setup setup = setup_of(raised(square(8, "alternating", 0.3), 0.3), fabric, {obstacle}, 100, 5);
    setup.world.gravity.y() = -1e5;
    Simulation simulation(std::move(setup));
    FrameReport report;
    while (simulation.frame() < simulation.frames() && report.trouble.empty()) report = simulation.advance();
    CHECK_THAT(report.trouble,
               Catch::Contains("m inside an obstacle at t = ") &&
                   Catch::Contains("times their length, between contact points too far apart"));
    // the last good frame is kept
    const Faces faces = simulation.model().cloths[0].mesh.faces;
    CHECK(lattice_distance(faces, simulation.state().x, obstacle, 0) > -0.02);
    CHECK(simulation.state().time == Approx(simulation.frame() / 100.0));
}
