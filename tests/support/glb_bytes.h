// A glTF binary of any JSON and any numbers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes.h"

namespace drape::test {

inline std::string glb_bytes(std::string_view json, std::string_view binary) {
    const auto size = [](size_t bytes) {
        std::vector<std::uint8_t> word;
        put<std::endian::little>(word, static_cast<std::uint32_t>(bytes));
        return std::string(word.begin(), word.end());
    };
    std::string bytes = "glTF" + size(2) + size(28 + json.size() + binary.size());
    bytes.append(size(json.size()) + "JSON").append(json);
    bytes.append(size(binary.size())).append("BIN\0", 4).append(binary);
    return bytes;
}

}  // namespace drape::test
