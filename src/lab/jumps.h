// Where `shortest` changes the altitude that acts: how far its force jumps, and that of `blend`.
#pragma once

#include <vector>

#include "cloth/fabric.h"

namespace drape {

// The apex of an equilateral triangle goes once round its place at rest.
struct JumpSample {
    int corner = 0;                  // whose altitude is the shortest
    double turn_deg = 0;             // 0 towards the base's second end
    double shortest = 0, blend = 0;  // force on the apex along the base, over stretch stiffness times base
    double energy_shortest = 0, energy_blend = 0;  // over stretch stiffness times base squared
};
std::vector<JumpSample> forces_round_rest();

struct ForceJump {
    double turn_deg = 0;  // where `shortest` changes its altitude
    double shortest = 0,
           blend = 0;          // |change of force| / |force|, of all three corners, across 1e-9 of the turn
    double energy_change = 0;  // of `shortest`, relative
};
std::vector<ForceJump> jumps_round_rest();

// A triangle whose two edges of length 1 and `ratio`, `angle` [rad] apart, are strained alike, so that the
// altitudes onto them tie: the jump where one takes over from the other, over the larger force.
double jump_at_tie(AltitudeMode mode, double angle, double ratio);

}  // namespace drape
