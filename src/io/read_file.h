// A whole file into memory, or one line that says why not.
#pragma once

#include <cstdint>
#include <string>

namespace drape {

// Throws Error "FILE: no such file", "FILE: is a folder", "FILE: 3 GB is too large (at most 1 GB)", ...
std::string read_file(const std::string& path, std::uint64_t largest);

// Throws as read_file does; the file is not read.
void check_readable(const std::string& path, std::uint64_t largest);

}  // namespace drape
