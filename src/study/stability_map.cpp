#include "study/stability_map.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <mutex>

#include "base/error.h"
#include "base/timer.h"

namespace drape {

namespace {

// What cells of one cloth at one stiffness share.
struct Sample {
    Setup setup;
    SmallMotion motion;
};

// The cells of one cloth, still to be judged.
void add_cells(StabilityMap& map, size_t cloth, const std::vector<const Method*>& methods,
               const std::vector<Sample>& samples) {
    const auto add = [&](const Method* method, size_t k, double step, double limit, bool on_grid) {
        StabilityCell cell;
        cell.method = method;
        cell.cloth = cloth;
        cell.stiffness = map.stiffness[k];
        cell.step = step;
        cell.limit = limit;
        cell.on_grid = on_grid;
        cell.omega = samples[k].motion.all.omega;
        cell.is_soft = !samples[k].motion.is_small;
        map.cells.push_back(std::move(cell));
    };
    for (const Method* method : methods) {
        for (size_t k = 0; k < map.stiffness.size(); ++k) {
            const double limit = samples[k].motion.limit(*method);
            for (const double step : map.step) add(method, k, step, limit, true);
            for (const double share : limit_shares)
                if (const double step = share * limit; step >= map.step.front() && step <= map.step.back())
                    add(method, k, step, limit, false);
        }
    }
    for (size_t k = 0; k < map.stiffness.size(); ++k) add(nullptr, k, 0, INFINITY, true);
}

void judge(StabilityCell& cell, const Setup& setup, const Trial& trial) {
    cell.verdict = cell.method ? judge_method(setup, *cell.method, cell.step, cell.omega, trial)
                               : judge_auto(setup, cell.omega, trial);
    cell.step = cell.verdict.step;
}

// Takes cells in turn, whichever thread is free; each is judged for itself.
void judge_all(StabilityMap& map, const std::vector<std::vector<Sample>>& samples,
               const StabilityOptions& options) {
    std::atomic<size_t> next{0};
    std::mutex saying;
    const size_t total = map.cells.size(), tenth = std::max<size_t>(1, total / 10);
    const auto work = [&] {
        for (size_t i = next++; i < total && !options.stop(); i = next++) {
            StabilityCell& cell = map.cells[i];
            const auto k = std::lower_bound(map.stiffness.begin(), map.stiffness.end(), cell.stiffness) -
                           map.stiffness.begin();
            judge(cell, samples[cell.cloth][static_cast<size_t>(k)].setup, map.trial);
            if ((i + 1) % tenth != 0) continue;
            const std::lock_guard lock(saying);
            options.say(cat(i + 1, " of ", total, " cells"));
        }
    };
    std::vector<std::future<void>> helpers;
    for (int i = 1; i < options.threads; ++i) helpers.push_back(std::async(std::launch::async, work));
    work();
    for (std::future<void>& helper : helpers) helper.get();
}

}  // namespace

std::vector<double> decades(double low, double high, int per_decade) {
    const double span = std::log10(high / low);
    const int intervals = static_cast<int>(std::lround(span * per_decade));
    std::vector<double> values;
    for (int i = 0; i <= intervals; ++i) values.push_back(low * std::pow(10, span * i / intervals));
    return values;
}

std::vector<const StabilityCell*> StabilityMap::cells_of(size_t cloth, std::string_view name) const {
    std::vector<const StabilityCell*> found;
    for (const StabilityCell& cell : cells)
        if (cell.cloth == cloth && cell.name() == name) found.push_back(&cell);
    return found;
}

std::vector<std::string_view> StabilityMap::names() const {
    std::vector<std::string_view> names;
    for (const StabilityCell& cell : cells)
        if (std::find(names.begin(), names.end(), cell.name()) == names.end()) names.push_back(cell.name());
    return names;
}

StabilityMap make_stability_map(std::vector<StabilityCloth> cloths, size_t whole,
                                const StabilityOptions& options) {
    const double began = process_cpu_seconds();
    StabilityMap map;
    map.cloths = std::move(cloths);
    map.stiffness = options.stiffness;
    map.step = options.step;
    map.trial = options.trial;
    std::vector<std::vector<Sample>> samples;
    for (size_t c = 0; c < map.cloths.size(); ++c) {
        std::vector<Sample>& of_cloth = samples.emplace_back();
        for (const double stiffness : map.stiffness) {
            Setup setup = with_spring_constant(map.cloths[c].setup, stiffness);
            const SmallMotion motion = small_motion(setup);
            of_cloth.push_back({std::move(setup), motion});
        }
        add_cells(map, c, c < whole ? options.methods : std::vector<const Method*>{}, of_cloth);
    }
    judge_all(map, samples, options);
    if (options.recovery_trials > 0) map.recoveries = measure_recovery(options.recovery_trials, options.stop);
    map.cpu_seconds = process_cpu_seconds() - began;
    return map;
}

}  // namespace drape
