// A comparison as one page that needs no other file and no network.
#pragma once

#include <string>

#include "compare/compare.h"

namespace drape {

struct PageRequest {
    std::string result, reference;  // as compare() has them
    Asked asked;
    std::string accept;   // the command that makes the results the references
    std::string made_by;  // the program, with its version
};

// What failed comes first; each shown frame side by side, under a slider, blinking, as difference and as an
// eye sees it. Every name is escaped. Reads the pictures that it shows; throws Error where it cannot.
std::string comparison_page(Comparison comparison, const PageRequest& request);

}  // namespace drape
