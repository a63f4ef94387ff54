#include "base/numbers.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "base/error.h"

namespace drape {

namespace {

struct Unit {
    double size;
    const char* name;
};

// in the largest unit that leaves at least 1 before the point
template <std::size_t n>
std::string in_units(double value, const std::array<Unit, n>& units) {
    if (!std::isfinite(value)) return "-";
    for (const Unit& unit : units)
        if (std::abs(value) >= 0.9995 * unit.size) return cat(figure(value / unit.size), " ", unit.name);
    return cat(figure(value / units.back().size), " ", units.back().name);
}

}  // namespace

std::string figure(double value, int digits) {
    if (!std::isfinite(value)) return "-";
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    return text.data();
}

std::string length_text(double metres) {
    static constexpr std::array units{Unit{1, "m"}, Unit{1e-3, "mm"}, Unit{1e-6, "µm"}, Unit{1e-9, "nm"},
                                      Unit{1e-12, "pm"}};
    return in_units(metres, units);
}

std::string time_text(double seconds) {
    static constexpr std::array units{Unit{1, "s"}, Unit{1e-3, "ms"}, Unit{1e-6, "µs"}};
    return in_units(seconds, units);
}

}  // namespace drape
