#include "study/probe.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "simulate/error_estimate.h"
#include "simulate/predicted_cost.h"
#include "simulate/twin.h"

namespace drape {

namespace {

// A study costs about this many passes at the longest stable step: references some 15, the rungs of all
// methods the rest.
constexpr double study_passes = 40;

// Where the twin is farther away than this no method can be told from another [m].
constexpr double predictable = 1e-4;

int wanted_frames(const Setup& setup, std::optional<double> until) {
    if (!until) return setup.frames;
    const double frames = std::round(*until * setup.frame_rate);
    if (frames < 1 || frames > setup.frames)
        throw Error(cat("--until ", *until, ": the scene has frames from ", 1 / setup.frame_rate, " to ",
                        setup.frames / setup.frame_rate, " s"));
    return static_cast<int>(frames);
}

std::string window_text(const Setup& setup, int frames, const std::string& ended_by) {
    const double seconds = frames / setup.frame_rate;
    if (frames == setup.frames) return cat("the whole scene, ", figure(seconds), " s");
    return cat("the first ", figure(seconds), " s (", frames, " frames), ", ended_by);
}

}  // namespace

Probe probe_scene(const Setup& given, std::optional<double> until, double budget) {
    Setup setup = given;
    setup.frames = wanted_frames(given, until);
    setup.method = "verlet";
    setup.step.reset();
    Setup moved = setup;
    moved.start = moved_a_little(setup.model, setup.start);
    Simulation simulation(setup), twin(std::move(moved));
    Probe probe;
    probe.conservative = simulation.dynamics().is_conservative();
    probe.contact = simulation.dynamics().contact() != nullptr;
    probe.friction = simulation.rubs();
    probe.size = (setup.start.x.rowwise().maxCoeff() - setup.start.x.rowwise().minCoeff()).norm();
    std::string trouble, ended_by = "as asked";
    while (simulation.frame() < setup.frames) {
        const FrameReport frame = simulation.advance();
        trouble = frame.trouble;
        if (!trouble.empty() || !twin.advance().trouble.empty()) {
            ended_by = "beyond which a Verlet pass goes wrong";
            break;
        }
        const double floor = distance_between(simulation.state().x, twin.state().x).rms;
        if (!until && floor > predictable && !probe.floor.empty()) {
            ended_by = cat("beyond which a start moved by 1e-12 m ends more than ", length_text(predictable),
                           " away (--until takes more)");
            break;
        }
        probe.cpu_seconds += frame.cpu_seconds;
        probe.floor.push_back(floor);
        if (!until && probe.cpu_seconds > budget / study_passes) {
            ended_by = "as much as the budget allows";
            break;
        }
    }
    probe.frames = static_cast<int>(probe.floor.size());
    if (probe.frames == 0) throw Error(trouble, Exit::went_wrong);
    probe.window = window_text(given, probe.frames, ended_by);
    const double predicted = predicted_cost(simulation).seconds * probe.frames / setup.frames;
    probe.calibration = probe.cpu_seconds / predicted;
    return probe;
}

double seconds_per_step(const Simulation& simulation, const Probe& probe) {
    const PredictedCost cost = predicted_cost(simulation);
    return probe.calibration * cost.seconds / (cost.steps / simulation.frames());
}

}  // namespace drape
