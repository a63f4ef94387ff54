// Drawings of a comparison's page, as SVG.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drape {

struct Mark {
    std::string name;
    std::optional<double> value = {};  // none: one side lacks it
    std::string text = {};             // the value, as people read it
    bool bad = false;
    std::string link = {};  // "#id" of what it belongs to on the page; "" = nothing
};

// A bar for each mark, on a scale of decades, in order; bad ones in red, the first of them named. A dashed
// line at the limit. `what` says what the bars are.
std::string timeline(const std::vector<Mark>& marks, std::optional<double> limit, const std::string& what);

// Pixels by the levels that they differ, 0 to 255, in classes that double; bars on a scale of decades.
std::string histogram(const std::array<std::int64_t, 256>& pixels);

}  // namespace drape
