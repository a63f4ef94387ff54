#include "app/flag_values.h"

#include <charconv>
#include <cmath>

#include "base/error.h"

namespace drape {

std::array<int, 2> pair_of(const std::string& text, char separator, const std::string& flag,
                           const std::string& allowed) {
    std::array<int, 2> pair{};
    const char *at = text.data(), *const end = at + text.size();
    for (const size_t i : {0U, 1U}) {
        const auto [stop, error] = std::from_chars(at, end, pair[i]);
        const bool last = i == 1, separated = !last && stop != end && *stop == separator;
        if (error != std::errc() || (last ? stop != end : !separated))
            throw Error(cat(flag, " ", text, ": expected ", allowed));
        at = stop + 1;
    }
    return pair;
}

double positive_number(const std::string& text, const std::string& flag, const std::string& allowed) {
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || stop != text.data() + text.size() || !(value > 0) || !std::isfinite(value))
        throw Error(cat(flag, " ", text, ": expected ", allowed));
    return value;
}

}  // namespace drape
