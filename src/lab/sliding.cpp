#include "lab/sliding.h"

#include <cmath>

#include "base/error.h"
#include "base/names.h"
#include "lab/elastic.h"
#include "mesh/pattern.h"
#include "obstacle/obstacle.h"
#include "simulate/simulation.h"

namespace drape {

Slide slide_down(double slope, double friction, std::string_view method, std::optional<double> step) {
    Slide slide;
    slide.angle = std::atan(slope);
    const double cosine = std::cos(slide.angle), sine = std::sin(slide.angle);
    const Vec3 downhill(cosine, -sine, 0), normal(sine, cosine, 0);
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
    setup.world.gravity = {0, -sliding_gravity, 0};
    setup.frame_rate = 10;
    setup.frames = 20;
    setup.method = method;
    setup.step = step;
    ShapeParameters plane;
    plane.normal = normal;
    setup.obstacles.push_back(
        {"plane", find_named(solid_kinds(), "obstacle", "plane").make(plane), {}, friction});
    Simulation simulation(std::move(setup));
    const Points lifted = simulation.state().x;
    double half_way = 0;
    while (simulation.frame() < simulation.frames()) {
        const FrameReport report = simulation.advance();
        if (!report.trouble.empty()) throw Error(cat("a sheet on a slope: ", report.trouble));
        const Points moved = simulation.state().x - lifted;
        slide.way =
            std::max(slide.way, (moved - normal * (normal.transpose() * moved)).colwise().norm().maxCoeff());
        slide.speed = downhill.dot(Vec3(simulation.state().v.rowwise().mean()));
        if (2 * simulation.frame() == simulation.frames()) half_way = slide.speed;
    }
    slide.acceleration = slide.speed - half_way;
    return slide;
}

double sliding_acceleration(double slope, double friction) {
    const double angle = std::atan(slope);
    return sliding_gravity * (std::sin(angle) - friction * std::cos(angle));
}

}  // namespace drape
