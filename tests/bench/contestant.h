// Contestants of a race to an error: each a ladder of settings, the cheapest first. Climbing finds which
// settings reach an error, racing times those in turn with all others, so that what disturbs the machine hits
// all alike.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/points.h"

namespace drape::bench {

struct Outcome {
    Points x = {};                    // at the final time; empty: went wrong
    std::string trouble = {};         // why
    double apart = 0;                 // CPU of a predictability twin, which is stated apart [s]
    std::optional<double> told = {};  // the error that the run itself states [m]
};

struct Entry {
    std::string setting = {};
    std::function<Outcome(double most_cpu)> run = {};  // may give up once it took that long [s]

    double error = INFINITY;  // RMS over the vertices at the final time [m]
    double cpu = INFINITY;    // least of all runs, without `apart` [s]
    double apart = 0;         // of that run [s]
    std::optional<double> told = {};
    std::string trouble = {};
};

struct Contestant {
    std::string name = {};
    std::vector<Entry> entries = {};
    int order = 0;  // of entries that are numbers of steps; 0: not known, or they are not
    std::optional<double> only_for = {};  // takes part for this error alone [m]
};

// Numbers of steps, each a tenth more than the last, over three decades.
inline constexpr double ladder_ratio = 1.1;
std::vector<int> steps_ladder(double fewest);

// Goes on with the ladder until `error` [m] is reached, or an entry takes more than `most_cpu` [s]. Entries
// whose order does not let them reach it are left out.
void climb(Contestant& contestant, const Points& exact, double error, double most_cpu);

// Entries that reach `error` [m] and may be the cheapest to do so.
std::vector<Entry*> candidates(Contestant& contestant, double error);

// The cheapest that reaches it; null: none does.
const Entry* cheapest(const Contestant& contestant, double error);

// Runs all once more in turn, those dearer than `dear` [s] not at all.
void race(const std::vector<Entry*>& entries, double dear);

}  // namespace drape::bench
