// A stability map: every method at every spring constant and step, on several cloths.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "study/collapse.h"
#include "study/stability_cloth.h"
#include "study/stability_run.h"

namespace drape {

inline constexpr const char* auto_name = "auto";

struct StabilityOptions {
    std::vector<double> stiffness;       // of the springs, increasing evenly on a log axis [N/m]
    std::vector<double> step;            // the same [s]
    std::vector<const Method*> methods;  // to be tried
    Trial trial;
    int recovery_trials = 0;  // of every altitude mode
    int threads = 1;          // not used to change any result
    std::function<void(const std::string&)> say = [](const std::string&) {};
    std::function<bool()> stop = [] { return false; };  // true: the map's rest is left unjudged
};

// Evenly on a log axis from `low` to `high`, both included.
std::vector<double> decades(double low, double high, int per_decade);

// Shares of the theoretical limit at which explicit methods are tried besides the grid.
inline constexpr std::array limit_shares{0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 1.02, 1.05, 1.1, 1.2};

struct StabilityCell {
    const Method* method = nullptr;  // null: drape's own choice
    size_t cloth = 0;                // which of the map's
    double stiffness = 0, step = 0;  // [N/m], [s]
    double limit = INFINITY;         // the longest stable step by theory [s]
    bool on_grid = true;             // false: near the limit
    bool is_soft = false;            // the cloth's weight stretches it far, and its modes change with that
    double omega = 0;                // of the fastest mode [1/s]
    Verdict verdict;

    std::string_view name() const { return method ? method->name : auto_name; }
};

struct StabilityMap {
    std::vector<StabilityCloth> cloths;
    std::vector<double> stiffness, step;  // the grid [N/m], [s]
    std::vector<StabilityCell> cells;     // cloth by cloth, method by method, auto last
    Trial trial;
    std::vector<Recovery> recoveries;  // empty: not measured
    double cpu_seconds = 0;

    std::vector<const StabilityCell*> cells_of(size_t cloth, std::string_view name) const;
    std::vector<std::string_view> names() const;  // of what was tried
};

// `cloths`: all methods are tried on the first `whole` of them, on the others drape's own choice alone.
StabilityMap make_stability_map(std::vector<StabilityCloth> cloths, size_t whole,
                                const StabilityOptions& options);

}  // namespace drape
