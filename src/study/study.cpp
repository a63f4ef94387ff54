#include "study/study.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/timer.h"

namespace drape {

namespace {

constexpr double reference_share = 0.45;   // of the budget that is left after the probe, for both references
constexpr double cheap_pass = 1.0 / 4000;  // of the budget: such passes allow twice as many rungs
constexpr double dearest_rung = 0.25;      // of what is left when the ladder starts

// Rungs one by one, then repeated round by round, so that what disturbs the machine hits all alike.
class Climb {
public:
    Climb(Study& study, const Setup& setup, const StudyOptions& options, const DrawState& draw)
        : study_(study), setup_(setup), options_(options), draw_(draw) {
        if (draw_) picture_ = draw_(study.reference.end);
    }

    void first_round(double budget) {
        Ladder ladder(setup_, study_.probe, options_.methods,
                      study_.probe.cpu_seconds < cheap_pass * options_.budget);
        study_.refused = ladder.refused();
        const double began = process_cpu_seconds(), cap = options_.repeats > 1 ? budget / 2 : budget;
        while (std::optional<Rung> rung = ladder.next()) {
            const double left = cap - (process_cpu_seconds() - began);
            const double allowed = std::min(left, dearest_rung * budget);
            if (rung->predicted_cpu > allowed)
                rung->left_out = cat("would cost about ", figure(rung->predicted_cpu), " CPU s");
            else
                measure(*rung, allowed);
            options_.say(summary(*rung));
            ladder.done(*rung);
            study_.rungs.push_back(std::move(*rung));
        }
    }

    void repeat(double budget) {
        std::vector<Rung*> again;
        for (Rung& rung : study_.rungs)
            if (rung.good()) again.push_back(&rung);
        const auto cost = [](const Rung* rung) { return rung->cpu.front(); };
        std::sort(again.begin(), again.end(), [&](auto* a, auto* b) { return cost(a) < cost(b); });
        for (int round = 1; round < options_.repeats; ++round) {
            double left = budget / (options_.repeats - 1);
            for (Rung* rung : again) {
                if (cost(rung) > left) break;
                const MeasuredPass pass =
                    measure_pass(with_steps(setup_, rung->method->name, rung->steps_a_frame), INFINITY);
                left -= pass.cpu_seconds;
                rung->cpu.push_back(pass.cpu_seconds);
                rung->wall.push_back(pass.wall_seconds);
            }
            options_.say(cat("round ", round + 1, " of ", options_.repeats, " done"));
        }
    }

private:
    void measure(Rung& rung, double most_cpu) {
        const Reference& reference = study_.reference;
        rung.pass = measure_pass(with_steps(setup_, rung.method->name, rung.steps_a_frame), most_cpu,
                                 [&](const State& state) {
                                     const size_t k = rung.distance.size();
                                     rung.distance.push_back(distance_between(state.x, reference.x[k]));
                                 });
        rung.cpu = {rung.pass.cpu_seconds};
        rung.wall = {rung.pass.wall_seconds};
        if (rung.pass.cut_short) {
            rung.left_out =
                cat("stopped after ", figure(rung.pass.cpu_seconds), " CPU s at frame ", rung.pass.frames);
        } else if (!rung.pass.trouble.empty()) {
            rung.failed = rung.pass.trouble;
        } else if (const double apart = rung.distance.back().rms; !(apart < study_.probe.size)) {
            rung.failed =
                cat("ended ", length_text(apart), " from the reference, farther than the cloth is large");
        } else {
            rung.errors = reported_errors(rung.distance, reference.bar);
            if (draw_) rung.picture = picture_difference(draw_(rung.pass.end), picture_);
        }
    }

    static std::string summary(const Rung& rung) {
        const std::string what = cat(rung.method->name, ", ", rung.steps_a_frame, " steps a frame: ");
        if (!rung.failed.empty()) return what + rung.failed;
        if (!rung.left_out.empty()) return what + rung.left_out;
        return cat(what, figure(rung.cpu.front()), " CPU s, error ", rung.errors.below_bar ? "< " : "",
                   length_text(rung.errors.final_rms));
    }

    Study& study_;
    const Setup& setup_;
    const StudyOptions& options_;
    const DrawState& draw_;
    Image picture_;
};

}  // namespace

std::vector<const Rung*> Study::rungs_of(const Method& method) const {
    std::vector<const Rung*> found;
    for (const Rung& rung : rungs)
        if (rung.method == &method && rung.good()) found.push_back(&rung);
    return found;
}

std::vector<const Method*> Study::methods() const {
    std::vector<const Method*> found;
    for (const Method& method : drape::methods())
        if (!rungs_of(method).empty()) found.push_back(&method);
    return found;
}

Study run_study(Setup setup, const StudyOptions& options, const DrawState& draw) {
    const double began = process_cpu_seconds();
    const auto left = [&] { return options.budget - (process_cpu_seconds() - began); };
    Study study;
    study.frame_rate = setup.frame_rate;
    study.probe = probe_scene(setup, options.until, options.budget);
    setup.frames = study.probe.frames;
    options.say(cat("studied: ", study.probe.window));
    study.reference = make_reference(setup, study.probe, reference_share * left());
    options.say(cat("reference: ", study.reference.how));
    options.say(cat("checked by: ", study.reference.checked_by));
    options.say(cat("error bar ", length_text(study.bar()), " RMS, predictability floor ",
                    length_text(study.floor()), ", at the last frame"));
    Climb climb(study, setup, options, draw);
    const double budget = left();
    climb.first_round(budget);
    climb.repeat(std::max(0.0, std::min(left(), budget / 2)));
    std::stable_sort(study.rungs.begin(), study.rungs.end(), [](const Rung& a, const Rung& b) {
        return a.method != b.method ? a.method < b.method : a.steps_a_frame < b.steps_a_frame;
    });
    study.cpu_seconds = process_cpu_seconds() - began;
    return study;
}

}  // namespace drape
