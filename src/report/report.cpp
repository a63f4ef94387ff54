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

Json counted(int count) {
    return count < 0 ? Json(nullptr) : Json(count);
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

Json frame_json(const FrameReport& frame, const std::string& picture) {
    return {{"index", frame.index},
            {"time_s", frame.time},
            {"hash", frame.hash},
            {"picture_hash", picture.empty() ? Json(nullptr) : Json(picture)},
            {"error_m", known(frame.error_rms)},
            {"error_max_m", known(frame.error_max)},
            {"steps", frame.steps},
            {"planned_steps", frame.planned_steps},
            {"retries", frame.retries},
            {"shortest_step_s", frame.shortest_step},
            {"contacts", frame.contacts},
            {"crossings", counted(frame.crossings)},
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
            {"reached", error.reached ? Json(*error.reached) : Json(nullptr)},
            {"how", error.how},
            {"passes", passes}};
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

int RunReport::crossings_max() const {
    int most = -1;
    for (const FrameReport& frame : frames) most = std::max(most, frame.crossings);
    return most;
}

bool RunReport::budget_kept() const {
    constexpr double over = 1.1;
    return !budget || spent() <= over * *budget;
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
    json["vertices"] = r.vertices;
    json["method"] = {{"name", r.method->name},
                      {"step_s", r.step},
                      {"steps", r.steps()},
                      {"factorisations", r.solver.factorisations},
                      {"solver_iterations", r.solver.iterations},
                      {"margin", known(r.longest_step / r.step)},
                      {"guaranteed_step_s", known(r.guaranteed_step)},
                      {"chosen_because", r.chosen_because}};
    json["error"] = error_json(r.error);
    json["budget"] = r.budget
                         ? Json{{"asked_s", *r.budget}, {"spent_s", r.spent()}, {"kept", r.budget_kept()}}
                         : Json(nullptr);
    const StageTimes& t = r.times;
    json["time"] = {{"total_s", t.total},       {"load_s", t.load},       {"build_s", t.build},
                    {"simulate_s", t.simulate}, {"contact_s", t.contact}, {"error_s", t.error},
                    {"render_s", t.render},     {"encode_s", t.encode},   {"write_s", t.write},
                    {"video_s", t.video},       {"wall_s", t.wall}};
    json["memory_peak_mb"] = peak_memory_mb();
    json["energy"] = {{"start_j", r.start.total()},
                      {"end_j", r.end.total()},
                      {"dissipated_j", r.flow.dissipated},
                      {"driven_j", r.flow.driven},
                      {"drift_j", r.energy_drift()}};
    json["contact"] = {{"deepest_penetration_m", r.deepest_penetration()},
                       {"least_distance_m", known(r.least_distance())},
                       {"contacts_max", r.contacts_max()},
                       {"crossings", counted(r.crossings_max())},
                       {"crossings_last", counted(r.frames.empty() ? -1 : r.frames.back().crossings)}};
    json["plan"] = plan_json(r.plan);
    json["notes"] = r.notes;
    json["frames"] = Json::array();
    for (size_t k = 0; k < r.frames.size(); ++k)
        json["frames"].push_back(frame_json(r.frames[k], k < r.pictures.size() ? r.pictures[k] : ""));
    // a file's name may hold bytes that are no UTF-8
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace drape
