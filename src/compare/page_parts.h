// The page's style and script: page.css and page.js, as part of the program.
#pragma once

#include <string_view>

namespace drape {

std::string_view page_style();
std::string_view page_script();

}  // namespace drape
