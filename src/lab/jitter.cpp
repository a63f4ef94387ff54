// Notes: let only the shortest altitude act; cloth then jitters.
#include "lab/jitter.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "base/assert.h"
#include "base/error.h"
#include "base/numbers.h"
#include "lab/elastic.h"
#include "lab/kinds.h"
#include "lab/plot.h"
#include "mesh/pattern.h"
#include "scene/fabric_words.h"
#include "simulate/simulation.h"
#include "study/csv.h"
#include "study/plot_style.h"

namespace drape {

namespace {

using std::numbers::pi;

constexpr double sheet_side = 0.5, gravity = 9.81;  // [m], [m/s^2]
constexpr int sheet_divisions = 12, steps_a_sample = 4;
constexpr double lead_in = 0.25, seconds = 1.25;  // [s]
constexpr double beyond = 1.1;                    // of the fastest mode: what lies above is no mode's
constexpr double shown = 0.06;                    // of a trace [s]

// In place; the length is a power of two.
void transform(std::vector<std::complex<double>>& x) {
    const size_t count = x.size();
    for (size_t i = 1, j = 0; i < count; ++i) {
        size_t bit = count / 2;
        for (; (j & bit) != 0; bit /= 2) j ^= bit;
        j ^= bit;
        if (i < j) std::swap(x[i], x[j]);
    }
    for (size_t length = 2; length <= count; length *= 2)
        for (size_t start = 0; start < count; start += length)
            for (size_t k = 0; k < length / 2; ++k) {
                const double angle = -2 * pi * static_cast<double>(k) / static_cast<double>(length);
                const std::complex<double> turned = std::polar(1.0, angle) * x[start + k + length / 2];
                x[start + k + length / 2] = x[start + k] - turned;
                x[start + k] += turned;
            }
}

Fabric cloth_with(AltitudeMode mode) {
    Fabric fabric;
    fabric.density = 0.15;
    fabric.stretch = 50;
    fabric.altitude = mode;
    fabric.damping = 0.05;
    return fabric;
}

LabFigure jitter_figure(const std::vector<Jitter>& all, double threshold) {
    PanelGrid grid{2, 1, 430, 340};
    grid.right = 150;
    LabFigure figure{
        "jitter",
        "Left: the power of the acceleration of a falling sheet by frequency. No mode of the sheet at "
        "rest is faster than the dashed line. Right: the acceleration of one vertex, moment by moment.",
        grid.width(),
        grid.height(),
        "",
        grid.begin("How jerkily cloth moves") + plain_panel() +
            cat("set key at screen 0.995,0.86 right top Left reverse\nset logscale xy\n",
                "set xrange [8:", jitter_rate / 2, "]\nset format y '10^{%T}'\n",
                "set xlabel 'frequency [Hz]'\nset ylabel 'power of acceleration [m^2/s^4 / Hz]'\n",
                "set arrow 1 from ", threshold, ",graph 0 to ", threshold,
                ",graph 1 nohead lc rgb '#999999' dt (4,4)\n")};
    std::string density, trace;
    for (size_t i = 0; i < all.size(); ++i) {
        std::vector<std::array<double, 2>> power, signal;
        for (size_t k = 1; k < all[i].density.size(); ++k)
            power.push_back({static_cast<double>(k) * jitter_rate / jitter_window, all[i].density[k]});
        for (size_t k = 0; k < all[i].trace.size() && static_cast<double>(k) < shown * jitter_rate; ++k)
            signal.push_back({1e3 * static_cast<double>(k) / jitter_rate, all[i].trace[k]});
        figure.data += data_block(cat("p", i), power) + data_block(cat("t", i), signal);
        const std::string line = cat(" using 1:2 with lines lw 2 lc rgb '", plot_colour(i), "' ");
        density += cat(i == 0 ? "plot $p" : ", $p", i, line, "title ",
                       plot_quoted(std::string(word_for(altitude_words, all[i].mode))));
        const bool of_interest = all[i].mode == AltitudeMode::shortest || all[i].mode == AltitudeMode::blend;
        if (of_interest) trace += cat(trace.empty() ? "plot $t" : ", $t", i, line, "notitle");
    }
    figure.plot +=
        cat(density, "\nunset arrow 1\nunset logscale\nset format y\nset xrange [0:", 1e3 * shown,
            "]\nset xlabel 'time [ms]'\nset ylabel 'acceleration [m/s^2]'\n", trace, "\nunset multiplot\n");
    return figure;
}

std::string jitter_csv(const std::vector<Jitter>& all) {
    std::string text = "altitudes,frequency_hz,power_of_acceleration_m2_per_s4_hz\n";
    for (const Jitter& jitter : all)
        for (size_t k = 0; k < jitter.density.size(); ++k)
            text += cat(word_for(altitude_words, jitter.mode), ",",
                        csv_number(static_cast<double>(k) * jitter_rate / jitter_window), ",",
                        csv_number(jitter.density[k]), "\n");
    return text;
}

}  // namespace

std::vector<double> power_density(std::span<const double> signal, int length, double rate) {
    const auto count = static_cast<size_t>(length);
    DRAPE_ASSERT(signal.size() >= count);
    std::vector<double> window(count), density(count / 2 + 1, 0);
    double weight = 0;
    for (size_t i = 0; i < count; ++i) {
        window[i] = 0.5 - 0.5 * std::cos(2 * pi * static_cast<double>(i) / length);
        weight += window[i] * window[i];
    }
    int windows = 0;
    for (size_t from = 0; from + count <= signal.size(); from += count / 2, ++windows) {
        std::vector<std::complex<double>> x(count);
        for (size_t i = 0; i < count; ++i) x[i] = window[i] * signal[from + i];
        transform(x);
        for (size_t k = 0; k <= count / 2; ++k)
            density[k] += (k == 0 || k == count / 2 ? 1 : 2) * std::norm(x[k]) / (rate * weight);
    }
    for (double& one : density) one /= windows;
    return density;
}

double Jitter::power_above(double frequency) const {
    const double apart = jitter_rate / jitter_window;
    double sum = 0;
    for (size_t k = 0; k < density.size(); ++k)
        if (static_cast<double>(k) * apart >= frequency) sum += density[k] * apart;
    return sum;
}

Jitter measure_jitter(AltitudeMode mode, double duration) {
    Setup setup;
    setup.model =
        free_cloth(make_pattern("alternating", {sheet_side, sheet_side, sheet_divisions, sheet_divisions}),
                   cloth_with(mode));
    const Points rest = setup.model.cloths.front().mesh.rest;
    std::vector<int> corners;
    for (int v = 0; v < setup.model.vertices(); ++v)
        if (std::abs(rest(0, v)) > sheet_side / 2 - 1e-9 && rest(2, v) < -sheet_side / 2 + 1e-9)
            corners.push_back(v);
    hold_at_rest(setup.model, corners);
    setup.start = {rest, Points::Zero(3, rest.cols()), 0};
    setup.world.gravity = {0, -gravity, 0};
    setup.frame_rate = jitter_rate;
    setup.frames = static_cast<int>(duration * jitter_rate);
    setup.method = "verlet";
    setup.step = 1 / (jitter_rate * steps_a_sample);
    Simulation simulation(std::move(setup));
    Jitter jitter;
    jitter.mode = mode;
    jitter.fastest = simulation.spectrum().omega / (2 * pi);
    // the mean acceleration between samples, a row for each coordinate of each vertex
    std::vector<std::vector<double>> signals(static_cast<size_t>(rest.size()));
    while (simulation.frame() < simulation.frames()) {
        const Points before = simulation.state().v;
        const FrameReport report = simulation.advance();
        if (!report.trouble.empty()) throw Error(cat("a sheet that falls: ", report.trouble));
        if (simulation.state().time < lead_in) continue;
        const Points change = jitter_rate * (simulation.state().v - before);
        for (Eigen::Index i = 0; i < change.size(); ++i)
            signals[static_cast<size_t>(i)].push_back(change.data()[i]);
    }
    jitter.density.assign(jitter_window / 2 + 1, 0);
    const double free = static_cast<double>(rest.cols()) - static_cast<double>(corners.size());
    for (const std::vector<double>& signal : signals) {
        const std::vector<double> one = power_density(signal, jitter_window, jitter_rate);
        for (size_t k = 0; k < one.size(); ++k) jitter.density[k] += one[k] / free;
    }
    jitter.power = jitter.power_above(0);
    jitter.trace = signals[static_cast<size_t>(rest.size() / 2 + 1)];
    return jitter;
}

LabResult run_jitter() {
    std::vector<Jitter> all;
    double threshold = 0;
    for (const auto& word : altitude_words) {
        all.push_back(measure_jitter(word.choice, seconds));
        threshold = std::max(threshold, beyond * all.back().fastest);
    }
    const auto above = [&](AltitudeMode mode) {
        return std::find_if(all.begin(), all.end(), [&](const Jitter& one) { return one.mode == mode; })
            ->power_above(threshold);
    };
    const double blend = above(AltitudeMode::blend);
    LabResult result;
    result.claim = cat("acceleration faster than any mode of the sheet at rest, ", figure(threshold, 3),
                       " Hz: `shortest` has ", figure(above(AltitudeMode::shortest) / blend, 3),
                       " times the power of `blend`");
    LabTable table{{"altitudes", "root mean square acceleration [m/s\u00b2]",
                    cat("above ", figure(threshold, 3), " Hz [m/s\u00b2]"), "power there over `blend`",
                    "fastest mode at rest [Hz]"},
                   {},
                   1};
    for (const Jitter& one : all)
        table.rows.push_back({std::string(word_for(altitude_words, one.mode)), figure(std::sqrt(one.power)),
                              figure(std::sqrt(one.power_above(threshold))),
                              figure(one.power_above(threshold) / blend), figure(one.fastest)});
    result.story = {
        "A square of cloth, held at two corners, falls from level and swings. Small motion has no frequency "
        "above "
        "that of the fastest mode at rest; what acceleration lies above comes of forces that change "
        "abruptly: "
        "where `shortest` takes another altitude, and where a triangle collapses.",
        "All modes have the same step, a hundredth of a period there at most, and the same damping, so that "
        "what "
        "differs is the force alone."};
    result.figures = {jitter_figure(all, threshold)};
    result.tables = {table};
    result.csv = {{"jitter", jitter_csv(all)}};
    return result;
}

}  // namespace drape
