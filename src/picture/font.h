// The font file that is part of the program.
#pragma once

#include <cstdint>
#include <span>

namespace drape {

std::span<const std::uint8_t> font_file();

}  // namespace drape
