#include "bench/drape_contestants.h"

#include <array>

#include "base/error.h"
#include "base/numbers.h"
#include "bench/delivered.h"
#include "study/measure.h"

namespace drape::bench {

namespace {

constexpr std::array suitable{"takahashi_imada", "srkn4", "srkn6", "verlet", "rk4", "xpbd"};
constexpr double beyond_stable = 2;  // the first rung's step over the longest that is known to be stable
constexpr double first_projecting_step = 0.005;  // of methods that springs set no limit to [s]

Outcome run_fixed(const Setup& setup) {
    Simulation simulation(setup);
    while (simulation.frame() < simulation.frames())
        if (const FrameReport frame = simulation.advance(); !frame.trouble.empty())
            return {.trouble = frame.trouble};
    return {.x = simulation.state().x};
}

Outcome run_delivery(const Setup& setup, const DeliveryOptions& options) {
    const Delivered run = deliver(setup, options);
    if (!run.trouble.empty()) return {.trouble = run.trouble};
    return {.x = run.x.back(), .apart = run.twin, .told = run.stated.back()};
}

}  // namespace

std::vector<Contestant> fixed_settings(const Setup& setup) {
    std::vector<Contestant> contestants;
    for (const char* name : suitable) {
        const Method& method = method_named(name);
        const Simulation simulation(with_steps(setup, name, 1));
        const double first =
            method.projects_springs ? first_projecting_step : beyond_stable * simulation.longest_step();
        Contestant contestant{.name = cat("drape ", name), .order = method.order};
        for (const int steps : steps_ladder(1 / setup.frame_rate / first))
            contestant.entries.push_back(
                {.setting = cat(steps, " steps"),
                 .run = [&setup, name, steps](double) { return run_fixed(with_steps(setup, name, steps)); }});
        contestants.push_back(std::move(contestant));
    }
    return contestants;
}

Contestant to_tolerance(const Setup& setup, double tolerance) {
    Contestant contestant{.name = "drape, to a tolerance", .only_for = tolerance};
    contestant.entries.push_back(
        {.setting = "--tolerance " + figure(tolerance),
         .run = [&setup, tolerance](double) { return run_delivery(setup, {.tolerance = tolerance}); }});
    return contestant;
}

Contestant projections_with_error(const Setup& setup, double only_for) {
    Contestant contestant{.name = "drape, xpbd and its error", .order = 1, .only_for = only_for};
    for (const int steps : steps_ladder(1 / setup.frame_rate / first_projecting_step))
        contestant.entries.push_back({.setting = cat(steps, " steps"), .run = [&setup, steps](double) {
                                          return run_delivery(with_steps(setup, "xpbd", steps), {});
                                      }});
    return contestant;
}

Contestant nothing_asked(const Setup& setup) {
    Contestant contestant{.name = "drape, nothing asked"};
    contestant.entries.push_back(
        {.setting = "error estimated", .run = [&setup](double) { return run_delivery(setup, {}); }});
    return contestant;
}

}  // namespace drape::bench
