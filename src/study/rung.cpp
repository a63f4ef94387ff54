#include "study/rung.h"

#include <algorithm>
#include <cmath>

namespace drape {

namespace {

// Runs better than the reference all end about the bar away from it: that is the reference's error, not
// theirs.
constexpr double clear_of_bar = 1.1;

}  // namespace

double median(std::vector<double> values) {
    if (values.empty()) return NAN;
    std::sort(values.begin(), values.end());
    const size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

RungErrors reported_errors(const std::vector<ErrorNorms>& distance, const std::vector<ErrorNorms>& bar) {
    double apart = 0, unsure = 0;
    for (size_t k = 0; k < distance.size(); ++k) {
        apart += distance[k].rms * distance[k].rms;
        unsure += bar[k].rms * bar[k].rms;
    }
    const auto frames = static_cast<double>(distance.size());
    const ErrorNorms& last = distance.back();
    const ErrorNorms& last_bar = bar[distance.size() - 1];
    RungErrors errors;
    errors.final_rms = std::max(last.rms, last_bar.rms);
    errors.final_max = std::max(last.max, last_bar.max);
    errors.time_l2 = std::sqrt(std::max(apart, unsure) / frames);
    errors.below_bar = last.rms <= clear_of_bar * last_bar.rms;
    return errors;
}

}  // namespace drape
