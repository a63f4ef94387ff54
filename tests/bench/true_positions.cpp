#include "bench/true_positions.h"

#include <algorithm>

#include "base/error.h"
#include "base/timer.h"
#include "simulate/error_estimate.h"
#include "study/sundials_reference.h"

namespace drape::bench {

namespace {

constexpr double first_refinement = 4;    // times the steps that stability and contact ask for
constexpr double most_sundials_cpu = 60;  // [s]
constexpr double dearest_to_refine = 15;  // a run that took longer is not followed by a finer one [CPU s]

struct FineRun {
    std::vector<Points> x = {};  // per frame
    double refine = 0;
    double cpu = 0;  // [s]
};

FineRun run_fine(Setup setup, double refine) {
    FineRun run{.refine = refine};
    setup.method = "rk4";
    setup.refine = refine;
    Simulation simulation(std::move(setup));
    while (simulation.frame() < simulation.frames()) {
        const FrameReport frame = simulation.advance();
        if (!frame.trouble.empty()) throw Error(cat("the reference went wrong: ", frame.trouble));
        run.cpu += frame.cpu_seconds;
        run.x.push_back(simulation.state().x);
    }
    return run;
}

std::vector<double> distances(const std::vector<Points>& a, const std::vector<Points>& b) {
    std::vector<double> apart;
    for (size_t k = 0; k < a.size(); ++k) apart.push_back(distance_between(a[k], b[k]).rms);
    return apart;
}

double worst(const std::vector<double>& bar, size_t frames) {
    double worst = 0;
    for (size_t k = 0; k < std::min(frames, bar.size()); ++k) worst = std::max(worst, bar[k]);
    return worst;
}

}  // namespace

TruePositions true_positions(const Setup& setup, size_t frames, double wanted) {
    SundialsRun outside;
    if (setup.obstacles.empty()) outside = run_sundials(setup, most_sundials_cpu);
    FineRun fine = run_fine(setup, first_refinement);
    while (true) {
        const FineRun coarse = std::move(fine);
        TruePositions truth;
        if (!outside.x.empty()) {
            truth = {outside.x, distances(outside.x, coarse.x),
                     cat(outside.how, "; against rk4 at ", coarse.refine, " times its steps")};
            if (worst(truth.bar, frames) <= wanted) return truth;
        }
        fine = run_fine(setup, 2 * coarse.refine);
        TruePositions own{fine.x, distances(fine.x, coarse.x),
                          cat("rk4 at ", fine.refine, " times its steps, against ", coarse.refine, " times")};
        const double bar = worst(own.bar, frames);
        if (outside.x.empty() && bar <= wanted) return own;
        if (fine.cpu <= dearest_to_refine) continue;
        return outside.x.empty() || bar < worst(truth.bar, frames) ? own : truth;
    }
}

}  // namespace drape::bench
