// Numbers as bytes in a file's order, whatever the machine's own.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace drape {

// `value` (int32, float, double, ...) behind `bytes`.
template <std::endian Order, class Number>
void put(std::vector<std::uint8_t>& bytes, Number value) {
    std::array<std::uint8_t, sizeof(Number)> raw{};
    std::memcpy(raw.data(), &value, sizeof value);
    if constexpr (Order != std::endian::native) std::reverse(raw.begin(), raw.end());
    bytes.insert(bytes.end(), raw.begin(), raw.end());
}

// The number that begins at `bytes`, which has at least sizeof(Number) of them.
template <class Number>
Number number_at(const char* bytes, std::endian order) {
    std::array<char, sizeof(Number)> raw{};
    std::memcpy(raw.data(), bytes, sizeof raw);
    if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
    Number value{};
    std::memcpy(&value, raw.data(), sizeof value);
    return value;
}

}  // namespace drape
