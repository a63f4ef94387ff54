// A first look at the scene by the cheapest method that takes any: what a pass costs, how much of the scene
// the budget can study, and how predictable that is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulate/simulation.h"

namespace drape {

struct Probe {
    int frames = 0;             // of the scene that are studied
    std::string window;         // the same in words
    double cpu_seconds = 0;     // of one Verlet pass through them, as cheap as it gets
    double calibration = 1;     // measured over predicted CPU seconds, contact included
    std::vector<double> floor;  // how far the twin run is, RMS, per frame [m]
    bool conservative = false, contact = false, friction = false;
    double size = 0;  // of the cloth at its start: its box's diagonal [m]
};

// `until` [s] fixes the window; otherwise it is as long as `budget` [CPU s] and predictability allow. Throws
// Error (Exit::went_wrong) where not even the first frame can be simulated.
Probe probe_scene(const Setup& setup, std::optional<double> until, double budget);

// CPU seconds that the simulation's method needs for every step a frame it makes, for the whole window.
double seconds_per_step(const Simulation& simulation, const Probe& probe);

}  // namespace drape
