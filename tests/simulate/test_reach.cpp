#include "simulate/reach.h"

#include <catch2/catch.hpp>

#include "support/setups.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("no vertex travels farther than the allowance", "[simulate]") {
    Setup thrown = flag();
    thrown.start.v.colwise() = Vec3(0, 4, 2);
    for (const Setup& setup : {swatch(8, 200), flag(), ball_drop(), thrown}) {
        Simulation simulation(setup);
        const double duration = setup.frames / setup.frame_rate;
        const double allowance = travel_allowance(setup.model, setup.start, setup.world, duration);
        run(simulation);
        const double travelled = (simulation.state().x - setup.start.x).colwise().norm().maxCoeff();
        CHECK(travelled > 0.3);
        CHECK(travelled < allowance);
        CHECK(allowance < 20);  // a bound, not infinity
    }
}

TEST_CASE("the allowance grows with whatever can carry cloth farther", "[simulate]") {
    const Setup plain = swatch(4, 200);
    const auto allowance = [&](const Setup& setup, double duration = 1) {
        return travel_allowance(setup.model, setup.start, setup.world, duration);
    };
    const double least = allowance(plain);
    Setup windy = plain, thrown = plain, carried = plain;
    windy.world.air.wind = {5, 0, 0};
    thrown.start.v.col(3) = Vec3(0, 3, 0);
    hold(carried.model, {2}, carried.start.x, carry(0, 1, {2, 0, 0}));
    CHECK(allowance(windy) >= least + 5);
    CHECK(allowance(thrown) == Approx(least + 3));
    CHECK(allowance(carried) >= least + 2);
    CHECK(allowance(plain, 2) == Approx(least + 1.5 * 9.81));
}

TEST_CASE("clearance is the distance to where an obstacle is and to where it may go", "[simulate]") {
    const State start = swatch(4, 200).start;  // reaches from -0.5 to 0.5
    Obstacle ball = sphere({2, 0, 0}, 0.25);
    const double still = std::hypot(1.5, 0) - 0.25;
    CHECK(clearance(start, ball) == Approx(still));
    ball.motion = carry(0, 1, {-1, 0, 0});
    CHECK(clearance(start, ball) <= still - 1);
    ShapeParameters floor;
    floor.centre = {0, -3, 0};
    CHECK(clearance(start, obstacle_of("plane", floor)) == Approx(3));
    // a plane that turns may come anywhere
    CHECK(clearance(start, obstacle_of("plane", floor, 0, carry(0, 1, Vec3::Zero(), {0, 0, 90}))) <= 0);
}
