#include "video/effort.h"

#include <array>

namespace drape {

namespace {

constexpr std::array ladder{
    Effort{1, 50, 80, 1},       Effort{1, 30, 75, 0.8},      Effort{1, 25, 70, 0.62},
    Effort{1, 20, 65, 0.47},    Effort{1, 15, 60, 0.33},     Effort{0.8, 15, 55, 0.22},
    Effort{0.64, 15, 50, 0.15}, Effort{0.5, 12, 50, 0.085},  Effort{0.4, 12, 40, 0.05},
    Effort{0.3, 10, 40, 0.028}, Effort{0.25, 10, 30, 0.018},
};

}  // namespace

std::span<const Effort> efforts() {
    return ladder;
}

std::size_t next_effort(std::size_t tried, std::uint64_t bytes, std::uint64_t most) {
    // a tenth over: where the guess is a little off, the better one is found
    const double share =
        1.1 * ladder.at(tried).share * static_cast<double>(most) / static_cast<double>(bytes);
    std::size_t next = tried + 1;
    while (next + 1 < ladder.size() && ladder[next].share > share) ++next;
    return next;
}

}  // namespace drape
