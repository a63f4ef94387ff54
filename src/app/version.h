// What `drape --version` and report.json say.
#pragma once

#include <string_view>

namespace drape {

inline constexpr std::string_view version = DRAPE_VERSION;

}  // namespace drape
