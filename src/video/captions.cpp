#include "video/captions.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "io/read_file.h"

namespace drape {

namespace {

using Json = nlohmann::json;

constexpr std::uint64_t largest_report = std::uint64_t{256} << 20;  // [bytes]

struct Unit {
    double size;  // [SI]
    const char* name;
};
constexpr std::array lengths{Unit{1e-3, "mm"}, Unit{1e-6, "µm"}, Unit{1e-9, "nm"}};
constexpr std::array times{Unit{1e-3, "ms"}, Unit{1e-6, "µs"}};

// Two digits, or more of a large number, in the largest unit of which it is at least a tenth.
template <class Units>
std::string told(double value, const Units& units) {
    if (value == 0) return "0";
    const Unit* unit = &units.back();
    for (const Unit& larger : units)
        if (value >= 0.1 * larger.size) {
            unit = &larger;
            break;
        }
    const double number = value / unit->size;
    char text[48];
    std::snprintf(text, sizeof text, number < 99.5 ? "%.2g %s" : "%.0f %s", number, unit->name);
    return text;
}

std::string fixed(const char* format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

// The number at json[key], if it is known.
std::optional<double> number_at(const Json& json, const char* key) {
    const Json& value = json.at(key);
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

std::vector<std::string> facts_of(const Json& frame) {
    std::vector<std::string> facts{fixed("t = %.2f s", frame.at("time_s").get<double>())};
    if (const auto error = number_at(frame, "error_m")) facts.push_back("error " + told(*error, lengths));
    return facts;
}

ReportedRun run_of(const Json& json) {
    ReportedRun run;
    Caption& common = run.captions.common;
    common.title = json.at("scene").get<std::string>();
    common.facts.push_back(json.at("method").at("name").get<std::string>());
    if (const auto step = number_at(json.at("method"), "step_s"))
        common.facts.push_back("step " + told(*step, times));
    const Json& frames = json.at("frames");
    const auto seconds = number_at(json.at("time"), "total_s");
    if (seconds && !frames.empty())
        common.facts.push_back(fixed("%.0f ms a frame", 1e3 * *seconds / double(frames.size())));
    for (const Json& frame : frames) {
        const int index = frame.at("index").get<int>();
        run.captions.facts[index] = facts_of(frame);
        if (const double time = frame.at("time_s").get<double>(); time > 0) run.frame_rate = index / time;
    }
    return run;
}

}  // namespace

Caption Captions::of(int frame) const {
    Caption caption = common;
    if (const auto found = facts.find(frame); found != facts.end())
        caption.facts.insert(caption.facts.end(), found->second.begin(), found->second.end());
    return caption;
}

ReportedRun read_reported_run(const std::string& path) {
    const std::string bytes = read_file(path, largest_report);
    try {
        return run_of(Json::parse(bytes));
    } catch (const Json::exception&) {
        throw Error(path + ": is no report.json of a run (--no-caption and --fps do without)");
    }
}

}  // namespace drape
