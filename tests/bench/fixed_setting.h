// What a user who knew the truth would have run: the cheapest method and fixed step that meets a tolerance.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulate/simulation.h"

namespace drape::bench {

struct FixedSetting {
    std::string method = {};
    int steps = 0;   // a frame
    double cpu = 0;  // [s]
};

// The first `frames` frames count. Settings dearer than `most_cpu` [s] are not looked for; none: no other
// meets it.
std::optional<FixedSetting> cheapest_fixed_setting(const Setup& setup, const std::vector<Points>& exact,
                                                   size_t frames, double tolerance, double most_cpu);

// Its CPU time once more [s].
double time_again(const Setup& setup, const FixedSetting& setting);

}  // namespace drape::bench
