// One cell of a stability map: jittered runs of one method at one step, and the worst that they show.
#pragma once

#include <string>

#include "simulate/simulation.h"
#include "study/stability_state.h"

namespace drape {

// How a cell is tried.
struct Trial {
    int runs = 10;   // each from a start of its own; the first that does not hold ends the cell
    int steps = 80;  // of each, whatever their length
    // of each cell, in evaluations of the forces: a run that would pass it is dropped, and with the first run
    // the cell is left out
    long most_work = 100'000;
    int auto_frames = 3;  // of each run of drape's own choice, at 30 frames a second
};

struct Verdict {
    Stability state = Stability::stable;
    double step = 0;              // [s]
    double gained = 0, lost = 0;  // most at any look, of the energy at play
    int runs = 0;                 // that were finished
    std::string method, why;      // what auto chose; where it was refused: the reason
};

// `method` at exactly this step [s]: nothing shortens it and nothing is tried again. `omega`: of the fastest
// mode [1/s].
Verdict judge_method(const Setup& setup, const Method& method, double step, double omega, const Trial& trial);

// Drape's own choice of method and step, with everything that guards a run.
Verdict judge_auto(const Setup& setup, double omega, const Trial& trial);

}  // namespace drape
