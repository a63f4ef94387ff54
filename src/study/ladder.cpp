#include "study/ladder.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace drape {

namespace {

constexpr double widest = 0.98;                // of the longest stable step
constexpr int most_halvings = 5;               // of explicit steps: more cost much and teach nothing new
constexpr int most_halvings_of_any_step = 12;  // where the first step is a frame, not what is stable
constexpr int most_failures = 4;               // in a row
// Halved steps cost implicit methods less than twice as much: each is easier to solve for.
constexpr double implicit_growth = 0.6;

}  // namespace

int Ladder::Row::steps() const {
    return static_cast<int>(std::ceil(first * std::pow(ratio, rung) * (1 - 1e-9)));
}

double Ladder::Row::predicted_cpu() const {
    if (told == 0 || !method->is_implicit()) return seconds_per_step * steps();
    return seconds_per_step * told * std::pow(double(steps()) / told, implicit_growth);
}

Ladder::Ladder(const Setup& setup, const Probe& probe, const std::vector<const Method*>& methods, bool fine)
    : frame_time_(1 / setup.frame_rate) {
    for (const Method* method : methods) {
        try {
            const Simulation simulation(with_steps(setup, method->name, 1));
            Row row;
            row.method = method;
            row.ratio = fine && !method->is_implicit() ? std::sqrt(2.0) : 2;
            const double stable = widest * simulation.longest_step();
            row.first = std::isfinite(stable) ? std::max(1.0, std::ceil(frame_time_ / stable)) : 1;
            const bool any_step = method->is_implicit() || method->projects_springs;
            const int halvings = any_step ? most_halvings_of_any_step : most_halvings;
            row.most = static_cast<int>(std::lround(halvings / std::log2(row.ratio))) + 1;
            row.seconds_per_step = seconds_per_step(simulation, probe);
            rows_.push_back(row);
        } catch (const Error& error) {
            refused_.push_back({method, error.what()});
        }
    }
}

std::optional<Rung> Ladder::next() const {
    std::optional<Rung> cheapest;
    for (const Row& row : rows_) {
        if (row.rung >= row.most) continue;
        const double cpu = row.predicted_cpu();
        if (cheapest && cheapest->predicted_cpu <= cpu) continue;
        Rung rung;
        rung.method = row.method;
        rung.steps_a_frame = row.steps();
        rung.step = frame_time_ / rung.steps_a_frame;
        rung.predicted_cpu = cpu;
        cheapest = rung;
    }
    return cheapest;
}

void Ladder::done(const Rung& rung) {
    const auto row =
        std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.method == rung.method; });
    if (row == rows_.end()) return;
    row->failed = rung.failed.empty() ? 0 : row->failed + 1;
    const bool enough = rung.good() && rung.errors.below_bar;
    if (enough || !rung.left_out.empty() || row->failed >= most_failures) {
        row->rung = row->most;
        return;
    }
    // a whole pass tells its method's cost better than any prediction
    if (rung.good()) {
        row->told = rung.steps_a_frame;
        row->seconds_per_step = median(rung.cpu) / rung.steps_a_frame;
    }
    const int before = row->steps();
    do ++row->rung;
    while (row->rung < row->most && row->steps() == before);
}

}  // namespace drape
