#include "bench/contestant.h"

#include <algorithm>
#include <cmath>

#include "base/timer.h"
#include "simulate/error_estimate.h"

namespace drape::bench {

namespace {

constexpr double ladder_length = 1000;  // the last rung over the first
constexpr double on_slope = 0.01;       // larger errors need not fall with the method's order [m]
constexpr double cautious = 0.8;        // share of the way that the order allows
// Single runs are timed no better than this on a shared machine: within it any may be the cheapest.
constexpr double timing_doubt = 1.4;

// runs it, and keeps the least CPU time
Outcome timed(Entry& entry, double most_cpu) {
    const double began = thread_cpu_seconds();
    Outcome outcome = entry.run(most_cpu);
    const double cpu = thread_cpu_seconds() - began - outcome.apart;
    if (cpu < entry.cpu) {
        entry.cpu = cpu;
        entry.apart = outcome.apart;
    }
    return outcome;
}

// how many of the next entries cannot bring the error down by `factor`
size_t out_of_reach(const Contestant& contestant, double factor, double error) {
    if (contestant.order == 0 || !(error < on_slope)) return 0;
    const double rungs = std::log(factor) / (contestant.order * std::log(ladder_ratio));
    return static_cast<size_t>(std::max(0.0, std::ceil(cautious * rungs) - 1));
}

}  // namespace

std::vector<int> steps_ladder(double fewest) {
    std::vector<int> steps;
    for (double wanted = fewest; wanted < ladder_length * fewest; wanted *= ladder_ratio) {
        const int next = static_cast<int>(std::ceil(wanted));
        if (steps.empty() || next > steps.back()) steps.push_back(next);
    }
    return steps;
}

void climb(Contestant& contestant, const Points& exact, double error, double most_cpu) {
    std::vector<Entry>& entries = contestant.entries;
    for (size_t i = 0; i < entries.size(); ++i) {
        Entry& entry = entries[i];
        if (entry.error <= error) break;                                     // run before
        if (!entry.trouble.empty() || std::isfinite(entry.error)) continue;  // and not enough
        const Outcome outcome = timed(entry, most_cpu);
        entry.told = outcome.told;
        entry.trouble = outcome.trouble;
        if (outcome.x.size() > 0) {
            entry.error = distance_between(outcome.x, exact).rms;
            if (!std::isfinite(entry.error)) entry.trouble = "unstable";
        }
        if (entry.error <= error || entry.cpu > most_cpu) break;
        i += out_of_reach(contestant, entry.error / error, entry.error);
    }
}

std::vector<Entry*> candidates(Contestant& contestant, double error) {
    double least = INFINITY;
    for (const Entry& entry : contestant.entries)
        if (entry.error <= error) least = std::min(least, entry.cpu);
    std::vector<Entry*> found;
    for (Entry& entry : contestant.entries)
        if (entry.error <= error && entry.cpu < timing_doubt * least) found.push_back(&entry);
    return found;
}

const Entry* cheapest(const Contestant& contestant, double error) {
    const Entry* best = nullptr;
    for (const Entry& entry : contestant.entries)
        if (entry.error <= error && (!best || entry.cpu < best->cpu)) best = &entry;
    return best;
}

void race(const std::vector<Entry*>& entries, double dear) {
    for (Entry* entry : entries)
        if (entry->cpu <= dear) timed(*entry, INFINITY);
}

}  // namespace drape::bench
