// Springs of 1e9 N/m at one step a frame, which somebody insists on: 20000 times the explicit limit.
#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <numbers>

#include "simulate/default_method.h"
#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

constexpr int divisions = 6;
constexpr double stiffness = 1e9;  // [N/m]

// Held where it reaches farthest that way, one step a frame.
Setup forced(Mesh mesh, const Vec3& way) {
    const Eigen::RowVectorXd reach = way.transpose() * mesh.rest;
    std::vector<int> held;
    for (int i = 0; i < static_cast<int>(mesh.rest.cols()); ++i)
        if (reach[i] > reach.maxCoeff() - 1e-9) held.push_back(i);
    Setup setup = scene_of(std::move(mesh), bare_springs(stiffness), held);
    setup.frame_rate = 30;
    setup.step = 1.0 / 30;
    return setup;
}

Setup lying() {
    return forced(square(divisions), -Vec3::UnitX());
}

// It hangs already: x of the lying one is down.
Setup hung() {
    Mesh mesh = square(divisions);
    mesh.rest =
        Points(Eigen::AngleAxisd(-std::numbers::pi / 2, Vec3::UnitZ()).toRotationMatrix() * mesh.rest);
    return forced(std::move(mesh), Vec3::UnitY());
}

// How far statics lets each vertex sink in the plane x = 0, by the linear equations of a truss: exact but for
// squares of strains of 1e-8.
Points sinking(const Setup& setup) {
    const Model& model = setup.model;
    const Eigen::Index count = model.vertices();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * count, 3 * count);
    for (const Spring& spring : model.cloths[0].network.edges) {
        const Vec3 way = (setup.start.x.col(spring.b) - setup.start.x.col(spring.a)).normalized();
        const Mat3 block = spring.stiffness * way * way.transpose();
        matrix.block<3, 3>(3 * spring.a, 3 * spring.a) += block;
        matrix.block<3, 3>(3 * spring.b, 3 * spring.b) += block;
        matrix.block<3, 3>(3 * spring.a, 3 * spring.b) -= block;
        matrix.block<3, 3>(3 * spring.b, 3 * spring.a) -= block;
    }
    Eigen::VectorXd weight(3 * count);
    for (int i = 0; i < count; ++i) {
        weight.segment<3>(3 * i) = model.mass[i] * setup.world.gravity;
        for (int c = 0; c < 3; ++c) {
            const bool free = model.inverse_mass[i] > 0 && c != 0;  // nothing leaves the plane
            if (free) continue;
            matrix.row(3 * i + c).setZero();
            matrix.col(3 * i + c).setZero();
            matrix(3 * i + c, 3 * i + c) = 1;
            weight[3 * i + c] = 0;
        }
    }
    const Eigen::VectorXd sunk = matrix.fullPivLu().solve(weight);
    REQUIRE((matrix * sunk - weight).norm() < 1e-9 * weight.norm());
    return Eigen::Map<const Points>(sunk.data(), 3, count);
}

}  // namespace

TEST_CASE("one step a frame at 1e9 N/m hangs where statics says", "[simulate]") {
    const Setup setup = hung();
    const Points expected = sinking(setup);
    Simulation simulation(setup);
    CHECK(simulation.method().name == bounded_choice);
    run(simulation);
    const Points sunk = simulation.state().x - setup.start.x;
    const double deepest = expected.cwiseAbs().maxCoeff();
    CHECK(deepest > 1e-10);
    CHECK(deepest < 1e-7);
    CHECK((sunk - expected).cwiseAbs().maxCoeff() < 0.01 * deepest);
}

TEST_CASE("one step a frame at 1e9 N/m swings down, is bounded, and comes to rest", "[simulate]") {
    Setup setup = lying();
    setup.frames = 900;
    const Points rest = setup.start.x;
    Simulation simulation(std::move(setup));
    double highest = 0, farthest = 0;
    int shortened = 0;  // frames whose step was not solved at once
    while (simulation.frame() < simulation.frames()) {
        const FrameReport report = simulation.advance();
        REQUIRE(report.trouble == "");
        shortened += report.steps > 1;
        highest = std::max(highest, simulation.state().x.row(1).maxCoeff());
        farthest = std::max(farthest, report.strain);
    }
    CHECK(shortened < 10);
    CHECK(highest < 0.05);
    CHECK(farthest < 1e-5);
    CHECK(simulation.state().v.colwise().norm().maxCoeff() < 0.01);
    // down where x of the rest shape was: to a hundredth of the metre that the swatch is long
    for (int i = 0; i < rest.cols(); ++i) {
        const Vec3 place = simulation.state().x.col(i);
        CAPTURE(i);
        CHECK(std::abs(place.y() + (rest(0, i) - rest.row(0).minCoeff())) < 0.01);
        CHECK(std::abs(place.z() - rest(2, i)) < 0.01);
    }
}
