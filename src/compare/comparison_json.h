// A comparison for programs to read.
#pragma once

#include <string>

#include "compare/compared.h"

namespace drape {

// Stable keys: passed, cause, limits {by key}, files [{name, verdict, why, metrics {by metrics.h's keys},
// picture {...}, cache
// {...}}].
std::string comparison_json(const Comparison& comparison);

}  // namespace drape
