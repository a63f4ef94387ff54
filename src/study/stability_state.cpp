#include "study/stability_state.h"

#include <array>

namespace drape {

namespace {

// Blue holds, yellow to black does not: apart in hue for every kind of eye, and in lightness on grey paper.
constexpr std::array kinds{
    StabilityKind{"stable", "#2b7bba",
                  "the energy stays within a tenth of the energy at play of what it should be"},
    StabilityKind{"lossy", "#b5d7ee",
                  "more than a tenth of the energy at play is lost, beyond what damping explains"},
    StabilityKind{"gains energy", "#f6c945", "more than a tenth of the energy at play comes from nowhere"},
    StabilityKind{"unbounded", "#d9590f",
                  "strains or speeds beyond what all the energy that is there could give"},
    StabilityKind{"not finite", "#3a1212", "numbers overflow"},
    StabilityKind{"refused", "#9a9a9a",
                  "the method is not for such cloth, or found no solution of a step and said so"},
    StabilityKind{"left out", "#ececec", "a single run would have cost more than a cell may"},
};

}  // namespace

std::span<const StabilityKind> stability_kinds() {
    return kinds;
}

const StabilityKind& kind_of(Stability state) {
    return kinds[static_cast<size_t>(state)];
}

}  // namespace drape
