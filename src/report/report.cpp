#include "report/report.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <thread>

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace drape {

namespace {

using Json = nlohmann::ordered_json;

Json known(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json plan_json(const Plan& plan) {
    Json used = Json::array(), left_out = Json::array();
    for (const Stage& stage : plan.stages) {
        if (stage.used)
            used.push_back(stage.name);
        else
            left_out.push_back({{"stage", stage.name}, {"because", stage.because}});
    }
    return {{"used", used}, {"left_out", left_out}};
}

Json frame_json(const FrameReport& frame) {
    return {{"index", frame.index},
            {"time_s", frame.time},
            {"hash", frame.hash},
            {"error_m", known(frame.error_rms)},
            {"error_max_m", known(frame.error_max)},
            {"steps", frame.steps},
            {"shortest_step_s", frame.shortest_step},
            {"contacts", frame.contacts},
            {"least_distance_m", known(frame.least_distance)},
            {"largest_strain", frame.strain},
            {"fastest_m_per_s", frame.fastest}};
}

Json error_json(const ErrorAccount& error) {
    Json passes = Json::array();
    for (const PassRecord& pass : error.passes)
        passes.push_back({{"method", pass.method},
                          {"purpose", pass.purpose},
                          {"step_s", pass.step},
                          {"steps", pass.steps},
                          {"sweeps", pass.sweeps},
                          {"estimated_rms_m", known(pass.error_rms)},
                          {"cpu_s", pass.cpu_seconds}});
    return {{"asked_m", error.asked ? Json(*error.asked) : Json(nullptr)},
            {"estimated_rms_m", known(error.rms)},
            {"estimated_max_m", known(error.max)},
            {"predictability_floor_m", known(error.floor)},
            {"below_floor_from_s", known(error.floor_from)},
            {"reached", error.asked ? Json(error.reached) : Json(nullptr)},
            {"how", error.how},
            {"passes", passes}};
}

std::string number(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string millimetres(double metres) {
    return cat(number("%.3g", metres * 1e3), " mm");
}

// The error's curve over the frames in one line, a step of a block for each factor of ten.
std::string error_curve(const std::vector<FrameReport>& frames) {
    constexpr std::array<std::string_view, 8> block{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
    constexpr double least_decade = -8;  // 10 nm and below
    constexpr size_t width = 60;
    const size_t columns = std::min(width, frames.size());
    std::string curve;
    for (size_t c = 0; c < columns; ++c) {
        const double error = frames[c * frames.size() / columns].error_rms;
        if (std::isnan(error)) return "";
        const double height = std::clamp(std::log10(error) - least_decade, 0.0, 7.0);
        curve += block[static_cast<size_t>(height)];
    }
    return curve.empty() ? ""
                         : cat("    over time, a step for each factor of ten, from 10 nm: ", curve, "\n");
}

std::string error_summary(const ErrorAccount& error) {
    if (!std::isfinite(error.rms)) return cat("  time-step error not known: ", error.how, "\n");
    std::string text = cat("  time-step error ", millimetres(error.rms), " RMS, ", millimetres(error.max),
                           " at most, in the worst frame");
    if (error.asked) text += cat(" (asked: ", millimetres(*error.asked), ")");
    text += cat("; ", number("%.1f", error.seconds), " CPU s on it\n    by ", error.how, "\n");
    if (std::isfinite(error.floor))
        text += cat("  predictability floor ", millimetres(error.floor),
                    ": a start moved by 1e-12 m ends that far away\n");
    if (std::isfinite(error.floor_from))
        text +=
            cat("    from t = ", number("%.4g", error.floor_from),
                " s on, what was asked lies below the floor: those frames are the best that can be done\n");
    if (!error.reached) text += "  the tolerance was not reached\n";
    return text;
}

}  // namespace

long RunReport::steps() const {
    long sum = 0;
    for (const FrameReport& frame : frames) sum += frame.steps;
    return sum;
}

double RunReport::least_distance() const {
    double least = INFINITY;
    for (const FrameReport& frame : frames) least = std::min(least, frame.least_distance);
    return least;
}

double RunReport::deepest_penetration() const {
    return std::max(0.0, -least_distance());
}

int RunReport::contacts_max() const {
    int most = 0;
    for (const FrameReport& frame : frames) most = std::max(most, frame.contacts);
    return most;
}

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

double peak_memory_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

std::string report_json(const RunReport& r) {
    Json json;
    json["scene"] = r.scene;
    json["version"] = r.version;
    json["machine"] = {{"processor", processor_name()},
                       {"cores", std::thread::hardware_concurrency()},
                       {"renderer", r.renderer.empty() ? Json(nullptr) : Json(r.renderer)}};
    json["method"] = {{"name", r.method->name},
                      {"step_s", r.step},
                      {"steps", r.steps()},
                      {"margin", known(r.longest_step / r.step)},
                      {"guaranteed_step_s", known(r.guaranteed_step)},
                      {"chosen_because", r.chosen_because}};
    json["error"] = error_json(r.error);
    const StageTimes& t = r.times;
    json["time"] = {{"total_s", t.total},       {"load_s", t.load},       {"build_s", t.build},
                    {"simulate_s", t.simulate}, {"contact_s", t.contact}, {"error_s", t.error},
                    {"render_s", t.render},     {"encode_s", t.encode},   {"write_s", t.write},
                    {"wall_s", t.wall}};
    json["memory_peak_mb"] = peak_memory_mb();
    json["energy"] = {{"start_j", r.start.total()},
                      {"end_j", r.end.total()},
                      {"dissipated_j", r.flow.dissipated},
                      {"driven_j", r.flow.driven},
                      {"drift_j", r.energy_drift()}};
    json["contact"] = {{"deepest_penetration_m", r.deepest_penetration()},
                       {"least_distance_m", known(r.least_distance())},
                       {"contacts_max", r.contacts_max()},
                       {"crossings", nullptr}};
    json["plan"] = plan_json(r.plan);
    json["notes"] = r.notes;
    json["frames"] = Json::array();
    for (const FrameReport& frame : r.frames) json["frames"].push_back(frame_json(frame));
    return json.dump(2) + "\n";
}

std::string report_summary(const RunReport& r) {
    const StageTimes& t = r.times;
    const double margin = r.longest_step / r.step;
    const std::string stable = std::isfinite(margin)
                                   ? number("%.2f", margin) + " of them would still be stable"
                                   : "any step is stable";
    std::string text = cat(r.scene, ": ", r.frames.size(), " frames, ", r.steps(), " steps of ",
                           r.method->name, ", ", number("%.3g", r.step * 1e6), " us each (", stable, ")\n");
    text += cat("  CPU ", number("%.1f", t.total), " s: simulate ", number("%.1f", t.simulate), " (contact ",
                number("%.1f", t.contact), "), render ", number("%.1f", t.render), ", encode ",
                number("%.1f", t.encode), "; wall ", number("%.1f", t.wall), " s; memory ",
                number("%.0f", peak_memory_mb()), " MB\n");
    text += cat("  energy ", number("%.4g", r.start.total()), " -> ", number("%.4g", r.end.total()),
                " J, heat ", number("%.4g", r.flow.dissipated), " J, put in ", number("%.4g", r.flow.driven),
                " J, unaccounted ", number("%.2g", r.energy_drift()), " J\n");
    if (std::isfinite(r.least_distance()))
        text += cat("  contact: at most ", r.contacts_max(), " points, never nearer than ",
                    number("%.3g", r.least_distance() * 1e3), " mm to an obstacle\n");
    if (!r.frames.empty())
        text += cat("  largest strain at the end ", number("%.2f", 100 * r.frames.back().strain), " %\n");
    return text + error_summary(r.error) + error_curve(r.frames);
}

}  // namespace drape
