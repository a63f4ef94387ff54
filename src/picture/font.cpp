#include "picture/font.h"

// the assembler copies the file: as source text it would take the compiler seconds
asm(".pushsection .rodata\n"
    "drape_font:\n"
    ".incbin \"" DRAPE_FONT
    "\"\n"
    "drape_font_end:\n"
    ".popsection\n");

extern "C" const std::uint8_t drape_font[], drape_font_end[];

namespace drape {

std::span<const std::uint8_t> font_file() {
    return {drape_font, drape_font_end};
}

}  // namespace drape
