#include "compare/comparison_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "compare/metrics.h"

namespace drape {

namespace {

using Json = nlohmann::ordered_json;

Json finite_or_null(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
    Json files = Json::array();
    for (const Compared& file : comparison.files) {
        Json row{{"name", file.name}, {"verdict", verdict_name(file.verdict)}, {"why", file.why}};
        Json found = Json::object();
        for (const Metric& metric : metrics())
            if (const std::optional<double> value = metric.value(file))
                found[std::string(metric.key)] = finite_or_null(*value);
        row["metrics"] = std::move(found);
        row["picture"] = file.picture ? Json{{"share_over", file.picture->share_over},
                                             {"mean_levels", file.picture->mean_levels},
                                             {"densest", file.picture->densest}}
                                      : Json(nullptr);
        row["cache"] = file.cache ? Json{{"sample", file.cache->sample},
                                         {"rms_m", finite_or_null(file.cache->rms_m)},
                                         {"most_m", finite_or_null(file.cache->most_m)},
                                         {"vertex", file.cache->vertex},
                                         {"from", file.cache->from}}
                                  : Json(nullptr);
        files.push_back(std::move(row));
    }
    const Json whole{{"passed", comparison.passed()},
                     {"cause", cause_of(comparison)},
                     {"limits", comparison.limits},
                     {"files", files}};
    return whole.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace drape
