// Whether runs to a tolerance keep it, by references that they do not know, and what that costs against the
// cheapest fixed setting that would have kept it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/error.h"
#include "base/numbers.h"
#include "bench/delivered.h"
#include "bench/fixed_setting.h"
#include "bench/table.h"
#include "bench/tolerance_scene.h"
#include "bench/true_positions.h"
#include "simulate/error_estimate.h"

namespace drape::bench {

namespace {

constexpr double wanted_bar = 0.1;  // of the tolerance, of the reference
constexpr double most_ratio = 4;    // of a run's cost over the cheapest fixed setting's, wanted
constexpr double brief = 2;         // runs shorter than this are timed again [s]
constexpr double clear_of_bar = 3;  // times the reference's bar: below, a true error is not known

struct Checked {
    const ToleranceScene* scene = nullptr;
    Delivered run;
    TruePositions truth;
    std::vector<double> error;  // true, RMS, per frame [m]
    size_t frames = 0;          // that count: those whose floor allows what was asked
    std::optional<FixedSetting> fixed;

    double worst(const std::vector<double>& values) const {
        double worst = NAN;
        for (size_t k = 0; k < std::min(frames, values.size()); ++k) worst = std::fmax(worst, values[k]);
        return worst;
    }
    bool delivered() const { return run.trouble.empty(); }
    bool judged() const { return !(worst(truth.bar) > scene->tolerance / 2); }
    bool holds() const {
        return delivered() && run.error.reached == true && judged() && !(worst(error) > scene->tolerance);
    }
    double ratio() const { return fixed ? run.cpu / fixed->cpu : NAN; }

    // the largest true error over the stated one, of frames whose truth is known
    double understated() const {
        double most = NAN;
        for (size_t k = 0; k < std::min(frames, error.size()); ++k)
            if (error[k] > clear_of_bar * truth.bar[k]) most = std::fmax(most, error[k] / run.stated[k]);
        return most;
    }

    std::string verdict() const {
        if (!delivered()) return "went wrong: " + run.trouble;
        std::string text;
        if (!(worst(error) <= scene->tolerance) && frames > 0) {
            text = "BROKEN in frames";
            for (size_t k = 0; k < frames; ++k)
                if (error[k] > scene->tolerance) text += cat(" ", k + 1);
        }
        if (!judged()) text += cat(text.empty() ? "" : "; ", "reference too coarse");
        if (run.error.reached != true) text += cat(text.empty() ? "" : "; ", "says not reached");
        if (text.empty()) text = "holds";
        if (frames < error.size()) text += cat(", floor from ", figure(run.error.floor_from), " s");
        return text;
    }
};

size_t frames_above_floor(const Setup& setup, const ErrorAccount& error, size_t delivered) {
    if (std::isnan(error.floor_from)) return delivered;
    const auto first_below = static_cast<size_t>(std::lround(error.floor_from * setup.frame_rate));
    return std::min(delivered, first_below - 1);
}

Checked check(const ToleranceScene& scene, bool ladder) {
    const Setup setup = setup_of(scene);
    Checked checked;
    checked.scene = &scene;
    checked.run = deliver(setup, {.tolerance = scene.tolerance});
    checked.frames = frames_above_floor(setup, checked.run.error, checked.run.x.size());
    checked.truth = true_positions(setup, checked.frames, wanted_bar * scene.tolerance);
    for (size_t k = 0; k < checked.run.x.size(); ++k)
        checked.error.push_back(distance_between(checked.run.x[k], checked.truth.x[k]).rms);
    if (!ladder || !checked.delivered() || checked.frames == 0) return checked;
    checked.fixed =
        cheapest_fixed_setting(setup, checked.truth.x, checked.frames, scene.tolerance, checked.run.cpu);
    if (!checked.fixed) return checked;
    if (checked.run.cpu < brief) {
        checked.run.cpu = std::min(checked.run.cpu, deliver(setup, {.tolerance = scene.tolerance}).cpu);
        checked.fixed->cpu = std::min(checked.fixed->cpu, time_again(setup, *checked.fixed));
    }
    return checked;
}

void print_frames(const Checked& checked) {
    for (size_t k = 0; k < checked.error.size(); ++k)
        std::printf("  frame %2zu%s: stated %s, true %s, bar %s\n", k + 1,
                    k < checked.frames ? "" : " (below the floor)", figure(checked.run.stated[k], 2).c_str(),
                    figure(checked.error[k], 2).c_str(), figure(checked.truth.bar[k], 2).c_str());
    for (const PassRecord& pass : checked.run.error.passes)
        std::printf("  pass %s, %s: %ld steps, error %s, %s CPU s\n", pass.method.c_str(),
                    pass.purpose.c_str(), pass.steps, figure(pass.error_rms, 2).c_str(),
                    figure(pass.cpu_seconds).c_str());
}

std::vector<std::string> row(const Checked& checked) {
    const Delivered& run = checked.run;
    return {checked.scene->name,
            figure(checked.scene->tolerance),
            figure(checked.worst(run.stated), 2),
            figure(checked.worst(checked.error), 2),
            figure(*std::max_element(checked.error.begin(), checked.error.end()), 2),
            figure(checked.worst(checked.truth.bar), 2),
            figure(run.error.floor, 2),
            checked.verdict(),
            figure(checked.understated(), 2),
            cat(run.method, " x ", run.error.passes.size()),
            figure(run.cpu),
            figure(run.twin),
            checked.fixed ? cat(checked.fixed->method, ", ", checked.fixed->steps, " a frame") : "-",
            checked.fixed ? figure(checked.fixed->cpu) : "-",
            figure(checked.ratio())};
}

int run(int argc, char** argv) {
    CLI::App app("whether runs to a tolerance keep it, and what that costs");
    std::vector<std::string> only;
    bool no_ladder = false, markdown = false, frames = false;
    app.add_option("--only", only, "these scenes alone");
    app.add_flag("--no-ladder", no_ladder, "do not look for the cheapest fixed setting");
    app.add_flag("--frames", frames, "every frame's errors and every pass");
    app.add_flag("--markdown", markdown, "the table as Markdown");
    CLI11_PARSE(app, argc, argv);

    Table table;
    table.head = {"scene",  "asked, m",    "stated, m",  "true, m",       "in any frame, m",
                  "bar, m", "floor, m",    "verdict",    "true / stated", "passes",
                  "CPU s",  "twin, CPU s", "best fixed", "its CPU s",     "ratio"};
    int checked = 0, held = 0;
    double worst_ratio = NAN;
    std::string worst_scene;
    for (const ToleranceScene& scene : tolerance_scenes()) {
        if (!only.empty() && std::find(only.begin(), only.end(), scene.name) == only.end()) continue;
        const Checked found = check(scene, !no_ladder);
        std::printf("%s: %s; reference %s\n", scene.name, found.verdict().c_str(), found.truth.how.c_str());
        if (frames) print_frames(found);
        std::fflush(stdout);
        ++checked;
        held += found.holds() ? 1 : 0;
        if (!(found.ratio() <= worst_ratio) && found.fixed) {
            worst_ratio = found.ratio();
            worst_scene = scene.name;
        }
        table.rows.push_back(row(found));
    }
    if (checked == 0) throw Error("no scene of that name");
    std::printf("\n%s\n", (markdown ? table.markdown() : table.text()).c_str());
    std::printf("%d of %d hold\n", held, checked);
    if (!no_ladder)
        std::printf("worst ratio %s, %s (at most %s wanted)\n", figure(worst_ratio).c_str(),
                    worst_scene.c_str(), figure(most_ratio).c_str());
    return held == checked ? 0 : 1;
}

}  // namespace

}  // namespace drape::bench

int main(int argc, char** argv) {
    try {
        return drape::bench::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "check_tolerance: %s\n", error.what());
        return 1;
    }
}
