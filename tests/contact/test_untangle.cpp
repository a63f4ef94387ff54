// Starts that cross themselves, taken apart.
#include "contact/untangle.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "simulate/simulation.h"
#include "support/meshes.h"
#include "support/obstacles.h"
#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

constexpr double gap = 0.01;

// Two level sheets of half a metre, the second above the first: 21 x 21 and 23 x 23 vertices.
Setup sheets() {
    Fabric fabric = full_fabric();
    fabric.thickness = 0.002;
    Setup setup = scene_of(square(20, "alternating", 0.5), fabric);
    Mesh above = square(22, "one_way", 0.5);
    above.rest.row(1).array() += gap;
    const Eigen::Index first = setup.start.x.cols(), all = first + above.vertices();
    setup.start.x.conservativeResize(3, all);
    setup.start.x.rightCols(above.vertices()) = above.rest;
    setup.start.v = Points::Zero(3, all);
    add_cloth(setup.model, make_cloth(std::move(above), fabric));
    for (Cloth& cloth : setup.model.cloths) cloth.self_contact = true;
    return setup;
}

// Presses a dent of that depth into the upper sheet.
void dent(Setup& setup, const Vec3& at, double radius, double depth) {
    for (Eigen::Index i = setup.model.cloths[1].first; i < setup.start.x.cols(); ++i) {
        const double away = (setup.start.x.col(i) - at).cwiseProduct(Vec3(1, 0, 1)).norm() / radius;
        if (away < 1) setup.start.x(1, i) -= depth * (1 + std::cos(M_PI * away)) / 2;
    }
}

Untangled untangled(Setup& setup) {
    return untangle(setup.model, setup.obstacles, setup.world.gravity, setup.start, 0.5);
}

// and that it starts, and a frame on has no crossing
void check_apart(const Setup& setup) {
    Simulation simulation(setup);
    const FrameReport report = simulation.advance();
    CHECK(report.trouble == "");
    CHECK(report.crossings == 0);
}

}  // namespace

TEST_CASE("a dent, a dipped edge and a dipped corner are drawn out of the cloth they pierce", "[contact]") {
    const Vec3 at = GENERATE(Vec3(0.02, 0, 0.01), Vec3(0.25, 0, 0.03), Vec3(0.25, 0, 0.25));
    Setup setup = sheets();
    dent(setup, at, 0.12, 0.025);
    const Untangled done = untangled(setup);
    CAPTURE(at.transpose(), done.before.pairs, done.rounds, done.largest_move);
    CHECK(done.before.pairs > 10);
    CHECK(done.largest_move < 0.05);  // twice as deep as the dent
    check_apart(setup);
}

TEST_CASE("a corner that is folded through its own cloth is drawn out", "[contact]") {
    Fabric fabric = full_fabric();
    fabric.thickness = 0.002;
    Setup setup = scene_of(square(24, "alternating", 0.5), fabric);
    setup.model.cloths[0].self_contact = true;
    // beyond a line across the corner everything is rolled over, and too far: down through the sheet
    constexpr double from = 0.1, radius = 0.03;
    for (Eigen::Index i = 0; i < setup.start.x.cols(); ++i) {
        const double out = (setup.start.x(0, i) + setup.start.x(2, i)) / std::sqrt(2) - from;
        if (out <= 0) continue;
        const double turned = std::min(out / radius, 1.2 * M_PI), rest = out - radius * turned;
        const double along = radius * std::sin(turned) + rest * std::cos(turned) - out;
        const double up = radius * (1 - std::cos(turned)) + rest * std::sin(turned);
        setup.start.x.col(i) += Vec3(along / std::sqrt(2), up, along / std::sqrt(2));
    }
    const Untangled done = untangled(setup);
    CAPTURE(done.before.pairs, done.rounds, done.largest_move);
    CHECK(done.before.pairs > 3);
    check_apart(setup);
}

TEST_CASE("what is pinned stays while cloth is untangled", "[contact]") {
    Setup setup = sheets();
    const int held = setup.model.cloths[1].first;
    add_pins(setup.model, {{held, held + 5}, setup.start.x.middleCols(held, 2), Vec3::Zero(), {}, false});
    dent(setup, {0.02, 0, 0.01}, 0.12, 0.025);
    const Points before = setup.start.x;
    untangled(setup);
    CHECK(setup.start.x.col(held) == before.col(held));
    CHECK(setup.start.x.col(held + 5) == before.col(held + 5));
}

TEST_CASE("cloth is drawn out of a mesh, which stays", "[contact]") {
    Fabric fabric = full_fabric();
    fabric.thickness = 0.002;
    Setup setup = scene_of(square(20, "alternating", 0.5), fabric);
    Mesh board = square(6, "one_way", 0.6);
    board.rest.row(1).array() -= 0.01;
    setup.obstacles.push_back(
        {"mesh", std::shared_ptr<const Solid>(make_mesh(std::move(board))), RigidMotion(), 0.3, 0.003});
    setup.start.x(1, 220) -= 0.03;
    const Untangled done = untangled(setup);
    CHECK(done.before.pairs > 3);
    check_apart(setup);
}

TEST_CASE("a start that crosses nothing is left as it is, to the last bit", "[contact]") {
    Setup setup = sheets();
    const Points before = setup.start.x;
    const Untangled done = untangled(setup);
    CHECK(done.before.pairs == 0);
    CHECK(done.rounds == 0);
    CHECK(setup.start.x == before);
    Setup alone = swatch(4, 100);
    CHECK(untangled(alone).before.pairs == 0);
}

TEST_CASE("sheets that cross from border to border are not said to be untangled", "[contact]") {
    Setup setup = sheets();
    for (Eigen::Index i = setup.model.cloths[1].first; i < setup.start.x.cols(); ++i)
        setup.start.x.col(i) = Vec3(setup.start.x(0, i), setup.start.x(2, i), 0.007);
    CHECK_THAT(error_of([&] { untangled(setup); }),
               Catch::Contains("cannot be untangled: ") && Catch::Contains("did at the start"));
}
