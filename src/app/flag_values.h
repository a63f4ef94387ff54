// Values of flags that CLI11 does not read by itself.
#pragma once

#include <array>
#include <string>

namespace drape {

// Two whole numbers with a separator: "1:10", "640x360". Throws Error that says what is allowed.
std::array<int, 2> pair_of(const std::string& text, char separator, const std::string& flag,
                           const std::string& allowed);
// Throws likewise.
double positive_number(const std::string& text, const std::string& flag, const std::string& allowed);

}  // namespace drape
