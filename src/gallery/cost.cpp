#include "gallery/cost.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "io/read_file.h"

namespace drape {

namespace {

using Json = nlohmann::json;

constexpr std::uint64_t largest_report = std::uint64_t{256} << 20;  // [bytes]

std::optional<double> known(const Json& value) {
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

}  // namespace

Cost read_cost(const std::string& path) {
    const std::string bytes = read_file(path, largest_report);
    try {
        const Json json = Json::parse(bytes);
        return {.scene = json.at("scene"),
                .method = json.at("method").at("name"),
                .vertices = json.at("vertices"),
                .frames = static_cast<int>(json.at("frames").size()),
                .step = known(json.at("method").at("step_s")),
                .error = known(json.at("error").at("estimated_rms_m")),
                .cpu = json.at("time").at("total_s"),
                .simulation = json.at("time").at("simulate_s"),
                .memory = json.at("memory_peak_mb")};
    } catch (const Json::exception&) {
        throw Error(path + ": is no report.json of a run of this version");
    }
}

}  // namespace drape
