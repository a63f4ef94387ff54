// How runs of one method at one step end: the states of a stability map, from best to worst.
#pragma once

#include <span>
#include <string_view>

namespace drape {

enum class Stability { stable, lossy, gains_energy, unbounded, not_finite, refused, left_out };

struct StabilityKind {
    std::string_view name;
    std::string_view colour;  // "#rrggbb"
    std::string_view meaning;
};

// In the order of the enumeration.
std::span<const StabilityKind> stability_kinds();
const StabilityKind& kind_of(Stability state);

// Motion stays bounded and takes no energy from nowhere.
inline bool holds(Stability state) {
    return state <= Stability::lossy;
}

// Of the energy at play: a larger loss that nothing explains is lossy, a larger gain (Guard::most_gain) is
// energy from nowhere, and beyond the last share strains or speeds hold twenty times what there was to have.
inline constexpr double most_loss = 0.1, bounded_gain = 0.9;

}  // namespace drape
