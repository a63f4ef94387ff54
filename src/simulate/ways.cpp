#include "simulate/ways.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "simulate/default_method.h"
#include "simulate/predicted_cost.h"

namespace drape {

namespace {

// A rough way is tried where judging it costs at most this share of judging the usual one.
constexpr double worth_trying = 0.5;

// xpbd's error over the size of the cloth, for each Verlet step that its step is long. Measured on the stiff
// swatch (50000 N/m, 0.2 s): 8.5e-4 with 33 x 33 and with 65 x 65 vertices; its passes state about twice
// that.
constexpr double softening_per_step = 1.7e-3;
constexpr double xpbd_refinement = 2;
// The lower the order, the more a distance is multiplied to give an error: passes farther apart say more.
constexpr double refinement_of_jumps = 1.6;
constexpr size_t xpbd_passes = 3;  // its order is seen, not assumed: it sets in late

double extent(In x) {
    return (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).norm();
}

// by the forces and the spectrum of `trial`, whatever its own method
Way way_of(const Simulation& trial, std::string_view method, std::string because) {
    const Method& taken = method_named(method);
    Way way{.method = std::string(method),
            .step = {},
            .because = std::move(because),
            .seconds = predicted_cost(trial, taken, trial.usual_step(taken)).seconds};
    if (trial.has_contact() || has_jumping_forces(trial.model())) way.refinement = refinement_of_jumps;
    return way;
}

// springs set its limit no more, so it needs a trial of its own
Simulation projecting(Setup setup) {
    setup.method = "xpbd";
    return Simulation(std::move(setup));
}

// The last of its passes is one step of symplectic Euler per `step`, whose error under gravity alone is
// g t h / 2, plus what separate steps of springs leave over.
std::optional<Way> xpbd_way(const Setup& setup, const Simulation& usual, double tolerance) {
    const double verlet_step = method_named("verlet").longest_step(usual.spectrum());
    const double duration = setup.frames / setup.frame_rate;
    double step = verlet_step * tolerance / (softening_per_step * extent(setup.start.x));
    if (const double g = setup.world.gravity.norm(); g > 0) step = std::min(step, tolerance / (g * duration));
    const Simulation trial = projecting(setup);
    const double coarsest =
        std::min({step * xpbd_refinement * xpbd_refinement, trial.longest_step(), 1 / setup.frame_rate});
    if (!(coarsest > 0)) return std::nullopt;
    Way way = way_of(trial, "xpbd",
                     "the tolerance is loose and the cloth stiff: small steps with one sweep of spring "
                     "projections are predicted to meet it for less than explicit steps");
    way.step = coarsest;
    way.seconds = predicted_cost(trial, trial.method(), coarsest).seconds;
    way.refinement = xpbd_refinement;
    way.least_passes = xpbd_passes;
    return way;
}

Way fine_way(const Simulation& trial, const std::string& usual) {
    const bool conserves = usual == "takahashi_imada";
    return way_of(trial, conserves ? "srkn6" : "rk4",
                  cat("there is much to refine: order ", conserves ? "six" : "four",
                      " gains more than many more steps of ", usual));
}

Ways only_way(const Setup& setup) {
    Ways ways;
    const Simulation trial(setup);
    ways.usual = way_of(trial, setup.method, setup.because);
    return ways;
}

}  // namespace

double seconds_to_judge(const Way& way) {
    double passes = 0;
    for (size_t k = 0; k < way.least_passes; ++k) passes += std::pow(way.refinement, double(k));
    return passes * way.seconds;
}

Ways ways_to(const Setup& setup, double tolerance) {
    if (!setup.method.empty()) return only_way(setup);
    Simulation trial(setup);
    const MethodChoice choice = explicit_choice(trial.dynamics());
    Ways ways;
    ways.usual = way_of(trial, choice.method, choice.because);
    // jumps leave no method its high order; contact may stay away
    if (!has_jumping_forces(setup.model)) ways.fine = fine_way(trial, choice.method);
    std::optional<Way> xpbd = xpbd_way(setup, trial, tolerance);
    Way implicit = way_of(trial, implicit_choice,
                          "so stiff that implicit steps are predicted to cost less than explicit ones");
    ways.rough = xpbd && seconds_to_judge(*xpbd) < seconds_to_judge(implicit) ? *xpbd : implicit;
    if (!(seconds_to_judge(*ways.rough) < worth_trying * seconds_to_judge(ways.usual))) ways.rough.reset();
    return ways;
}

Ways ways_within_budget(const Setup& setup) {
    if (!setup.method.empty()) return only_way(setup);
    Simulation trial(setup);
    const MethodChoice choice = explicit_choice(trial.dynamics());
    Ways ways;
    ways.usual = way_of(trial, choice.method, choice.because);
    // jumps leave no method its high order
    if (!trial.has_contact() && !has_jumping_forces(setup.model)) ways.fine = fine_way(trial, choice.method);
    ways.rough =
        way_of(projecting(setup), "xpbd", "the budget has no time for explicit steps; these may be longer");
    return ways;
}

Setup pass_along(const Way& way, Setup setup, double refine) {
    setup.method = way.method;
    setup.because = way.because;
    setup.step = way.step;
    setup.refine = refine;
    return setup;
}

}  // namespace drape
