// Style and script of a gallery's page, from page.css and page.js.
#pragma once

#include <string_view>

namespace drape {

std::string_view gallery_style();
std::string_view gallery_script();

}  // namespace drape
