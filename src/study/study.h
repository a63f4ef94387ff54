// A study: error against run time of every method on one scene, with the reference's own error stated.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/draw_state.h"
#include "study/ladder.h"
#include "study/mesh_refinement.h"
#include "study/reference.h"

namespace drape {

struct StudyOptions {
    std::optional<double> until;         // [s]; none: what the budget allows
    int repeats = 3;                     // of a rung, fewer where it is dear
    double budget = 600;                 // CPU s for all together
    std::vector<const Method*> methods;  // to be tried
    std::function<void(const std::string&)> say = [](const std::string&) {};
};

struct Study {
    std::string scene;
    double frame_rate = 0;  // [1/s]
    Probe probe;
    Reference reference;
    std::vector<Rung> rungs;  // method by method, the longest step first
    std::vector<RefusedMethod> refused;
    std::optional<MeshRefinement> refinement;
    double cpu_seconds = 0;  // of the study

    double floor() const { return probe.floor.back(); }             // at the last frame [m]
    double bar() const { return reference.bar.back().rms; }         // at the last frame [m]
    std::vector<const Rung*> rungs_of(const Method& method) const;  // good ones
    std::vector<const Method*> methods() const;                     // with a good rung
};

Study run_study(Setup setup, const StudyOptions& options, const DrawState& draw);

}  // namespace drape
