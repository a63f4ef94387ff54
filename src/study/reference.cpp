#include "study/reference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.h"
#include "base/numbers.h"
#include "study/measure.h"
#include "study/sundials_reference.h"

namespace drape {

namespace {

// A method, and how many times more steps than stability asks for are enough: more would only add round-off.
struct Candidate {
    std::string_view method;
    double finest;
};

// in the order of preference; the first that can be afforded is taken
std::vector<Candidate> first_candidates(const Probe& probe) {
    if (probe.conservative) return {{"srkn6", 4}, {"takahashi_imada", 16}, {"verlet", 64}};
    if (!probe.contact) return {{"rk4", 16}, {"verlet", 64}};
    return {{"verlet", 64}};
}

std::vector<Candidate> second_candidates(const Probe& probe) {
    if (probe.contact) return {{"rk4", 32}, {"takahashi_imada", 64}};
    return {{"verlet", 64}};
}

constexpr double coarsest = 2;  // times the steps that stability asks for

struct Choice {
    std::string_view method;
    int steps = 0;  // a frame
};

// The first candidate that `allowed` CPU seconds pay for, as fine as they do; `passes` is what the run costs
// in passes with that step. Nothing affordable: the cheapest.
Choice choose(const Setup& setup, const Probe& probe, const std::vector<Candidate>& candidates, double passes,
              double allowed) {
    Choice cheapest;
    double least = INFINITY;
    for (const Candidate& candidate : candidates) {
        const Simulation simulation(with_steps(setup, candidate.method, 1));
        const double stable = 1 / setup.frame_rate / simulation.longest_step();
        const double each = passes * seconds_per_step(simulation, probe);
        // even, so that half of them is a whole number, and stable
        const auto steps_for = [&](double times) {
            return 2 * static_cast<int>(std::ceil(times * stable / 2));
        };
        for (double times = candidate.finest; times >= coarsest; times /= std::sqrt(2.0))
            if (each * steps_for(times) <= allowed) return {candidate.method, steps_for(times)};
        if (each * steps_for(coarsest) < least) {
            least = each * steps_for(coarsest);
            cheapest = {candidate.method, steps_for(coarsest)};
        }
    }
    return cheapest;
}

struct Trajectory {
    std::vector<Points> x;
    MeasuredPass pass;
};

Trajectory run(const Setup& setup, const Choice& choice) {
    Trajectory run;
    run.pass = measure_pass(with_steps(setup, choice.method, choice.steps), INFINITY,
                            [&](const State& state) { run.x.push_back(state.x); });
    return run;
}

std::string said(const Setup& setup, const Choice& choice) {
    return cat(choice.method, " with steps of ", time_text(1 / setup.frame_rate / choice.steps), ", ",
               choice.steps, " a frame");
}

struct Second {
    std::vector<Points> x;  // empty: there is none
    std::string how;
};

Second second_run(const Setup& setup, const Probe& probe, double most_cpu) {
    if (probe.friction) {
        const Choice choice = choose(setup, probe, second_candidates(probe), 1, most_cpu);
        Trajectory other = run(setup, choice);
        const std::string why =
            "friction's impulses are no part of a differential equation, so no library "
            "for those can check: a second run of drape's own, ";
        if (!other.pass.trouble.empty()) return {{}, cat(why, "went wrong: ", other.pass.trouble)};
        return {std::move(other.x), cat(why, said(setup, choice))};
    }
    SundialsRun other = run_sundials(setup, most_cpu);
    return {std::move(other.x), std::move(other.how)};
}

}  // namespace

Reference make_reference(const Setup& setup, const Probe& probe, double most_cpu) {
    // a pass with half the steps tells the finer one's error
    const Choice choice = choose(setup, probe, first_candidates(probe), 1.5, most_cpu / 2);
    const Choice half{choice.method, choice.steps / 2};
    const Trajectory coarse = run(setup, half);
    Trajectory fine = run(setup, choice);
    if (!fine.pass.trouble.empty())
        throw Error(cat("the reference, ", said(setup, choice), ", went wrong: ", fine.pass.trouble),
                    Exit::went_wrong);
    Second second = second_run(setup, probe, most_cpu / 2);
    if (second.x.empty() && !coarse.pass.trouble.empty())
        throw Error(cat("nothing tells the reference's error: ", said(setup, half),
                        ", went wrong: ", coarse.pass.trouble, "; ", second.how),
                    Exit::went_wrong);

    Reference reference;
    reference.how = said(setup, choice);
    reference.checked = !second.x.empty();
    reference.checked_by = second.how;
    // contact comes and goes: assume the least
    const int order = method_named(choice.method)
                          .order_where(probe.conservative, probe.contact || has_jumping_forces(setup.model));
    const double share = error_share(choice.steps, half.steps, order);
    const double edge = mean_edge(setup.model);
    for (size_t k = 0; k < fine.x.size(); ++k) {
        const double least = round_off(fine.x[k], static_cast<double>(k + 1) * choice.steps);
        ErrorNorms bar{least, least};
        if (k < coarse.x.size()) {
            const ErrorNorms apart = distance_between(fine.x[k], coarse.x[k]);
            const double stated = stated_share(apart.rms, share, edge);
            reference.richardson = std::max(least, stated * apart.rms);
            // alone, the rule is not to be trusted with a smaller share: round-off follows none
            const double alone = std::max(1.0, stated);
            if (second.x.empty())
                bar = {std::max(least, alone * apart.rms), std::max(least, alone * apart.max)};
        }
        if (k < second.x.size()) {
            const ErrorNorms apart = distance_between(fine.x[k], second.x[k]);
            bar = {std::max(least, apart.rms), std::max(least, apart.max)};
        }
        reference.bar.push_back(bar);
    }
    reference.x = std::move(fine.x);
    reference.end = std::move(fine.pass.end);
    return reference;
}

}  // namespace drape
