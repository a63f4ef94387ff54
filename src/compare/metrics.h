// Every number that tells how far two results are apart, in one table: the program's flags, compare.toml,
// reports and the page all speak by it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/compared.h"

namespace drape {

struct Metric {
    std::string_view key = "";   // of its limit, in compare.toml and with --limit
    std::string_view name = "";  // in a sentence, after the number
    std::string_view unit = "";  // "%": a share, shown times 100; "levels": of 256; "m"; "": none
    std::string_view says = "";  // what it tells
    // none where it does not apply or was not asked for
    std::optional<double> (*value)(const Compared&) = nullptr;
    std::optional<double> usual = {};  // the limit where none is given; none: told, but not judged
    double most = 1;                   // that a limit may be; the least is 0
    bool at_least = false;             // its limit is a lower one
    std::string_view asked_by = "";  // the flag that asks for it; "": always there. A limit asks for it too.
};

// Those of pictures first.
std::span<const Metric> metrics();

std::vector<std::string> metric_keys();

// Throws Error that names the nearest known one.
const Metric& metric_of(std::string_view key);

bool exceeds(const Metric& metric, double value, double limit);

// As people read it: "0.002 %", "1 µm", "0.98".
std::string metric_text(const Metric& metric, double value);

}  // namespace drape
