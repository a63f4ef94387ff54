// report.json: what a run did, reached and cost. Keys are stable; what is not known is null, never made up.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/plan.h"
#include "simulate/delivery.h"

namespace drape {

// CPU seconds of the whole process and of the program that encodes a video, stage by stage; wall_s for the
// person who waited.
struct StageTimes {
    double load = 0, build = 0, simulate = 0, contact = 0, error = 0, render = 0, encode = 0, write = 0,
           video = 0;            // [s]
    double total = 0, wall = 0;  // [s]
};

struct RunReport {
    std::string scene, version, renderer;
    int vertices = 0;  // simulated, of all cloths
    const Method* method = nullptr;
    std::string chosen_because;
    double step = 0, longest_step = 0, guaranteed_step = 0;  // [s]
    SolverWork solver;
    StageTimes times;
    ErrorAccount error;
    std::optional<double> budget;  // of wall time [s]
    double spent_before = 0;       // of it, by the run that this one goes on from [s]
    Energies start, end;
    EnergyFlow flow;
    Plan plan;
    std::vector<FrameReport> frames;
    std::vector<std::string> pictures;  // hashes of these frames' files; "" or left out: none was drawn
    std::vector<std::string> notes;

    long steps() const;
    double deepest_penetration() const;  // how far any point ever was inside an obstacle [m]; 0 if never
    int contacts_max() const;
    int crossings_max() const;      // -1: not counted
    double least_distance() const;  // of any frame; infinite without obstacles [m]
    double spent() const { return spent_before + times.wall; }  // wall, since the run began [s]
    bool budget_kept() const;                                   // to 10 %; true if there was none
    // what energy came or went unaccounted: end - start - driven + dissipated [J]
    double energy_drift() const { return end.total() - start.total() - flow.driven + flow.dissipated; }
};

// The whole file.
std::string report_json(const RunReport& report);

// A few lines for the console.
std::string report_summary(const RunReport& report);

// What kind of machine: its processor's own name.
std::string processor_name();

// Largest resident memory of the process so far [MB].
double peak_memory_mb();

}  // namespace drape
