// A comparison as continuous integration reads it.
#pragma once

#include <string>

#include "compare/compared.h"

namespace drape {

// A JUnit file: a suite of this name, a case for each file, a failure with its reason where one is not the
// same.
std::string junit_report(const Comparison& comparison, const std::string& suite);

}  // namespace drape
