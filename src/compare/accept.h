// Results become references.
#pragma once

#include <string>

#include "compare/compare.h"

namespace drape {

// Writes what is different or new over the references and removes those that the result has not; what passed
// is left alone. Throws Error (Exit::cannot_write).
void accept(const Comparison& comparison, const std::string& result, const std::string& reference);

}  // namespace drape
