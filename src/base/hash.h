// FNV-1a, 64 bits: names the bytes of a frame or a state. Not for security.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace drape {

constexpr std::uint64_t hash_seed = 0xcbf29ce484222325ULL;

// Continues `hash` over `size` bytes.
std::uint64_t hash_bytes(const void* data, std::size_t size, std::uint64_t hash = hash_seed);

// Sixteen lower-case hexadecimal digits.
std::string hash_text(std::uint64_t hash);

}  // namespace drape
