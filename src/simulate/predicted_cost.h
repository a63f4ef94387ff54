// What a run will cost, from counted work: no clock, so the same scene is predicted alike everywhere.
#pragma once

#include "simulate/simulation.h"

namespace drape {

struct PredictedCost {
    double steps = 0;    // of the whole run, were each as long as the present one
    double seconds = 0;  // CPU, simulation alone [s]
};

PredictedCost predicted_cost(const Simulation& simulation);

// The same for another method on the scene, at steps of `step` [s].
PredictedCost predicted_cost(const Simulation& simulation, const Method& method, double step);

}  // namespace drape
