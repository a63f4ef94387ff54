// In which keys two scenes differ, as scene_text() prints them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drape {

// Dotted, as --set takes them, in the order of `now`: "cloth.0.pattern.divisions". A table or array that only
// one of the two has is named as a whole.
std::vector<std::string> changed_keys(std::string_view before, std::string_view now);

}  // namespace drape
