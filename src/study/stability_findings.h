// What a stability map says of each method, in one line.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "study/stability_map.h"

namespace drape {

// Over all cloths.
struct StabilityCount {
    std::array<int, 7> cells{};  // by state
    int total = 0;
    // Every cell up to this share of the theoretical limit holds; none: no limit, or none among the steps
    // that were tried. Where soft cloth stretches, the limit of small motion is not its own.
    std::optional<double> up_to, soft_up_to;

    int of(Stability state) const { return cells[static_cast<size_t>(state)]; }
    int failed() const;  // gained energy, went beyond bounds or was refused
};

StabilityCount count_cells(const StabilityMap& map, std::string_view name);

// "verlet: stable up to 0.98 of the theoretical limit (0.79 where soft cloth stretches); 84 of 120 cells
// (unbounded 30, gains energy 6)"
std::string summary_of(const StabilityMap& map, std::string_view name);

}  // namespace drape
