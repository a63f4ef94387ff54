#include "bench/true_positions.h"

#include <cmath>

#include "base/error.h"
#include "simulate/error_estimate.h"
#include "study/sundials_reference.h"

namespace drape::bench {

namespace {

// times the steps that stability and contact ask for
constexpr double fine = 8, coarser = 4, beside_sundials = 4;

std::vector<Points> run_fine(Setup setup, const char* method, double refine) {
    setup.method = method;
    setup.refine = refine;
    Simulation simulation(std::move(setup));
    std::vector<Points> x;
    while (simulation.frame() < simulation.frames()) {
        if (const FrameReport frame = simulation.advance(); !frame.trouble.empty())
            throw Error(cat("the reference went wrong: ", frame.trouble));
        x.push_back(simulation.state().x);
    }
    return x;
}

std::vector<double> distances(const std::vector<Points>& a, const std::vector<Points>& b) {
    std::vector<double> apart;
    for (size_t k = 0; k < a.size(); ++k) apart.push_back(distance_between(a[k], b[k]).rms);
    return apart;
}

}  // namespace

TruePositions true_positions(const Setup& setup, double most_cpu) {
    TruePositions truth;
    if (setup.obstacles.empty()) {
        SundialsRun run = run_sundials(setup, most_cpu);
        if (!run.x.empty()) {
            truth.x = std::move(run.x);
            truth.bar = distances(truth.x, run_fine(setup, "rk4", beside_sundials));
            truth.how = cat(run.how, "; against rk4 at ", beside_sundials, " times its steps");
            return truth;
        }
        truth.how = cat(run.how, ": ");
    }
    truth.x = run_fine(setup, "rk4", fine);
    truth.bar = distances(truth.x, run_fine(setup, "rk4", coarser));
    truth.how += cat("rk4 at ", fine, " times its steps, against ", coarser, " times");
    return truth;
}

}  // namespace drape::bench
