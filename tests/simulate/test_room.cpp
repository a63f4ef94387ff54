#include "simulate/room.h"

#include <catch2/catch.hpp>

#include "support/setups.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("the room of a scene holds everything at every frame, and not much else", "[simulate]") {
    const int scene = GENERATE(0, 1, 2);
    CAPTURE(scene);
    Setup setup = scene == 0 ? flag() : scene == 1 ? swatch(8, 500) : ball_drop();
    Simulation simulation(std::move(setup));
    const Eigen::AlignedBox3d room = room_of(simulation);
    Eigen::AlignedBox3d seen;
    while (simulation.frame() < simulation.frames()) {
        simulation.advance();
        for (Eigen::Index i = 0; i < simulation.state().x.cols(); ++i)
            seen.extend(Vec3(simulation.state().x.col(i)));
    }
    // springs this soft stretch as they swing: the cloth passes the room by up to 0.19 of its size
    const double slack = 0.25 * room.sizes().maxCoeff();
    CHECK((seen.min() - room.min()).minCoeff() > -slack);
    CHECK((room.max() - seen.max()).minCoeff() > -slack);
    CHECK(room.sizes().maxCoeff() < 2.5 * seen.sizes().maxCoeff());
}

TEST_CASE("moving obstacles take up their whole way, planes only a height", "[simulate]") {
    Setup setup = ball_drop();
    setup.obstacles[0].motion = carry(0, 0.5, {2, 0, 0});
    ShapeParameters floor;
    floor.centre = Vec3(0, -1.5, 0);
    setup.obstacles.push_back(obstacle_of("plane", floor));
    const Eigen::AlignedBox3d room = room_of(Simulation(std::move(setup)));
    CHECK(room.max().x() == Approx(2.32).margin(0.02));
    CHECK(room.min().y() == Approx(-1.5));
    CHECK(room.sizes().maxCoeff() < 4);
}
