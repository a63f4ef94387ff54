#include "bench/fixed_setting.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/timer.h"
#include "simulate/error_estimate.h"
#include "study/measure.h"

namespace drape::bench {

namespace {

// the likeliest to be cheap come first: what they cost ends the ladders of the others early
constexpr std::array laddered{"takahashi_imada",  "verlet", "srkn4", "srkn6",
                              "symplectic_euler", "rk4",    "xpbd"};
constexpr double widest = 0.98;  // of the longest stable step
constexpr double ladder_ratio = 1.25;
constexpr double first_projecting_step = 0.005;  // of methods that springs set no limit to [s]

double first_steps(const Setup& setup, const char* method) {
    const Simulation simulation(with_steps(setup, method, 1));
    const double step =
        simulation.method().projects_springs ? first_projecting_step : widest * simulation.longest_step();
    return std::max(1.0, std::ceil(1 / setup.frame_rate / step));
}

struct Run {
    double cpu = 0;     // [s]
    double worst = 0;   // RMS error of any frame that counts [m]
    bool whole = true;  // neither went wrong nor was stopped
};

// stopped once it is dearer than `most_cpu` [s]
Run run(const Setup& setup, const std::vector<Points>& exact, size_t frames, double most_cpu) {
    const double began = thread_cpu_seconds();
    Run run;
    Simulation simulation(setup);
    double compared = 0;
    while (simulation.frame() < simulation.frames()) {
        const FrameReport frame = simulation.advance();
        run.cpu = thread_cpu_seconds() - began - compared;
        run.whole = frame.trouble.empty() && run.cpu <= most_cpu;
        if (!run.whole) return run;
        const ThreadCpuScope timer(compared);
        const auto k = static_cast<size_t>(simulation.frame() - 1);
        if (k < frames) run.worst = std::max(run.worst, distance_between(simulation.state().x, exact[k]).rms);
    }
    return run;
}

}  // namespace

std::optional<FixedSetting> cheapest_fixed_setting(const Setup& setup, const std::vector<Points>& exact,
                                                   size_t frames, double tolerance, double most_cpu) {
    std::optional<FixedSetting> best;
    for (const char* method : laddered) {
        double wanted = 0;
        try {
            wanted = first_steps(setup, method);
        } catch (const Error&) {
            continue;  // not for such a scene
        }
        for (;; wanted = std::max(wanted * ladder_ratio, wanted + 1)) {
            const int steps = static_cast<int>(wanted);
            const Run found = run(with_steps(setup, method, steps), exact, frames, most_cpu);
            if (found.cpu > most_cpu) break;
            if (!found.whole || !(found.worst <= tolerance)) continue;
            best = FixedSetting{method, steps, found.cpu};
            most_cpu = found.cpu;
            break;
        }
    }
    return best;
}

double time_again(const Setup& setup, const FixedSetting& setting) {
    return run(with_steps(setup, setting.method, setting.steps), {}, 0, INFINITY).cpu;
}

}  // namespace drape::bench
