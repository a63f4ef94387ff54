// Whether an obstacle can matter: a bound on how far cloth travels in a scene's time.
#pragma once

#include "cloth/model.h"
#include "force/force.h"
#include "obstacle/obstacle.h"

namespace drape {

// How far from its start any vertex may get within `duration` [m]: free flight with the fastest start and
// with gravity, carried by the wind, drawn along by pins, and a swing about its own size. It is an allowance,
// not a theorem (springs could be wound up to throw farther), so the simulation checks it at every frame.
double travel_allowance(const Model& model, const State& start, const Surroundings& world, double duration);

// The least distance between the cloth's start and anywhere the obstacle goes, from below [m].
double clearance(const State& start, const Obstacle& obstacle);

}  // namespace drape
