// A run as its user gets it: frames in order, each with its error. Behind it stand one pass through the scene
// or several, each a Simulation.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulate/pacer.h"
#include "simulate/simulation.h"

namespace drape {

// One pass through the scene that the error was judged by.
struct PassRecord {
    std::string method;
    std::string purpose;
    double step = 0;  // [s]
    long steps = 0, sweeps = 0;
    double error_rms = NAN;  // its worst frame's, as far as known [m]
    double cpu_seconds = 0;
};

struct ErrorAccount {
    std::optional<double> asked;  // tolerance [m]
    double rms = NAN, max = NAN;  // of the worst frame delivered so far [m]
    double floor = NAN;           // predictability, largest over the frames [m]
    double floor_from = NAN;      // from this time on, what was asked lies below it [s]
    std::optional<bool> reached;  // what was asked, in every frame above the floor; none: not known yet
    std::string how;              // it was estimated
    double seconds = 0;           // CPU, apart from the delivered pass [s]
    std::vector<PassRecord> passes;

    // what was asked, in every frame: neither refused by refining nor below the floor
    bool met() const { return !asked || (reached.value_or(false) && std::isnan(floor_from)); }
};

// Where hidden passes stand, for a progress bar.
struct PassProgress {
    std::string what;
    int frame = 0, frames = 0;
    double error = NAN;  // so far [m]
};

class Delivery {
public:
    virtual ~Delivery() = default;

    // One frame of work: the next frame delivered, or nothing while passes before it run (progress() tells).
    virtual std::optional<FrameReport> advance() = 0;

    virtual const Simulation& simulation() const = 0;         // the pass that is delivered, or that runs
    virtual const State& state() const = 0;                   // at the last frame delivered
    virtual int frame() const = 0;                            // frames delivered
    virtual const Eigen::VectorXf& vertex_error() const = 0;  // of that frame [m]; empty: not known
    virtual const ErrorAccount& error() const = 0;
    virtual PassProgress progress() const = 0;
    virtual double spent_before() const { return 0; }  // of a budget, by a run that this one goes on from [s]

    // All that is needed to go on later with the same bits.
    virtual std::string save() const = 0;
    [[nodiscard]] virtual bool restore(std::string_view bytes) = 0;  // false: not such bytes
};

struct DeliveryOptions {
    std::optional<double> tolerance = {};  // [m]
    std::optional<Budget> budget = {};
    std::vector<long> replay = {};  // planned_steps of every frame of an earlier run
    bool estimate = true;           // run a second pass where no tolerance asks for one
    std::string no_estimate_because = "--no-estimate";
    int threads = 1;  // 2 or more: passes run side by side; changes no bit
    int frames = 0;   // that are wanted; 0 = the whole scene
};

std::unique_ptr<Delivery> make_delivery(Setup setup, const DeliveryOptions& options);

}  // namespace drape
