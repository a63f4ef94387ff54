// Files appear whole or not at all: written to a temporary name beside the target, flushed, renamed.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace drape {

// Throws Error (Exit::cannot_write) "FILE: cannot write: reason"; nothing half-written is left behind.
void write_file(const std::string& path, std::span<const std::uint8_t> bytes);
void write_file(const std::string& path, std::string_view text);

// Creates the folder and its parents. Throws Error (Exit::cannot_write).
void make_folder(const std::string& path);

}  // namespace drape
