// Text from a file, fit for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace drape {

// The text with '?' for each control character: one line, which moves no cursor and changes no colour.
std::string plain_line(std::string_view text);

}  // namespace drape
