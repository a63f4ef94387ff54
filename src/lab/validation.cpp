#include "lab/validation.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/names.h"
#include "base/numbers.h"
#include "lab/elastic.h"
#include "lab/hanging.h"
#include "mesh/pattern.h"
#include "obstacle/obstacle.h"
#include "simulate/simulation.h"

namespace drape {

namespace {

constexpr double gravity = 9.81;  // [m/s^2]

// Slides down `slope` for two seconds: how far, and how much faster in the second one.
struct Slide {
    double way = 0, acceleration = 0;  // [m], [m/s^2]
};

Slide slide(double slope, double friction) {
    const double angle = std::atan(slope);
    const Vec3 downhill(std::cos(angle), -std::sin(angle), 0), normal(std::sin(angle), std::cos(angle), 0);
    Fabric springs;
    springs.density = 0.2;
    springs.stretch_model = StretchModel::spring_constant;
    springs.stretch = 200;
    Setup setup;
    setup.model = free_cloth(make_pattern("alternating", {0.3, 0.3, 4, 4}), springs);
    Mat3 turn;
    turn << downhill, normal, Vec3::UnitZ();
    const Points start = turn * setup.model.cloths.front().mesh.rest;
    setup.start = {start, Points::Zero(3, start.cols()), 0};
    setup.world.gravity = {0, -gravity, 0};
    setup.frame_rate = 10;
    setup.frames = 20;
    setup.method = "verlet";
    ShapeParameters plane;
    plane.normal = normal;
    setup.obstacles.push_back(
        {"plane", find_named(solid_kinds(), "obstacle", "plane").make(plane), {}, friction});
    Simulation simulation(std::move(setup));
    const Points lifted = simulation.state().x;
    const auto speed = [&] { return downhill.dot(Vec3(simulation.state().v.rowwise().mean())); };
    double half_way = 0;
    while (simulation.frame() < simulation.frames()) {
        const FrameReport report = simulation.advance();
        if (!report.trouble.empty()) throw Error(cat("a sheet on a slope: ", report.trouble));
        if (2 * simulation.frame() == simulation.frames()) half_way = speed();
    }
    const Points moved = simulation.state().x - lifted;
    return {(downhill.transpose() * moved).cwiseAbs().maxCoeff(), speed() - half_way};
}

}  // namespace

HangingTip loaded_tip(std::string_view mesh, BendingKind kind, double load, int divisions) {
    const double length = loaded_length, square = length * length;
    Fabric fabric;
    fabric.membrane = MembraneKind::stvk;
    fabric.membrane_poisson = fabric.poisson = 0;
    fabric.bending_kind = kind;
    fabric.bending = 1e-5;
    fabric.density = load * fabric.bending / (square * length * gravity);
    // by 1e-4 of its length where it carries all its weight
    fabric.stretch = 1e4 * std::max(load, 10.0) * fabric.bending / square;
    return bend_strip(clamped_strip(mesh, {length, length / 10, divisions}), fabric, gravity);
}

// Bessel's zeros: half of them times sqrt(g / L).
std::vector<Check> check_curtain(int rows) {
    constexpr double length = 1, reference[] = {1.20241, 2.76004, 4.32686};
    Fabric fabric;
    fabric.density = 0.2;
    fabric.stretch = 2e5;  // its weight stretches it by a hundred thousandth
    const std::vector<double> found =
        swing_frequencies(hanging_sheet(length * 4 / rows, length, 4, rows), fabric, gravity);
    std::vector<Check> checks;
    for (size_t i = 0; i < std::size(reference); ++i)
        checks.push_back({cat("curtain, frequency ", i + 1, " / sqrt(g / L)"), "edge springs", reference[i],
                          found[i] / std::sqrt(gravity / length), 0.01, cat(rows, " rows")});
    return checks;
}

Check check_strip(const std::string& on, const Fabric& fabric, int rows) {
    constexpr double length = 1;
    const double expected = fabric.density * gravity * length * length / (2 * fabric.stretch);
    const double found = hanging_stretch(hanging_sheet(length * 2 / rows, length, 2, rows), fabric, gravity);
    return {"strip, stretch by its weight [mm]", on, 1e3 * expected, 1e3 * found, 0.005, cat(rows, " rows")};
}

std::vector<Check> check_slope() {
    constexpr double friction = 0.5, holds = 0.49, slides = 0.8;
    const double angle = std::atan(slides);
    return {{"slope, tan 0.49 under friction 0.5: way in 2 s [mm]", "verlet", 0,
             1e3 * slide(holds, friction).way, 1, "4 x 4"},
            {"slope, tan 0.8 over friction 0.5: acceleration [m/s\u00b2]", "verlet",
             gravity * (std::sin(angle) - friction * std::cos(angle)), slide(slides, friction).acceleration,
             0.01, "4 x 4"}};
}

}  // namespace drape
