#include "picture/palette.h"

#include <cstddef>

namespace drape {

ClothPalette cloth_palette(int cloth) {
    constexpr std::array<ClothPalette, 6> rows{{
        {{0.73f, 0.19f, 0.17f}, {0.87f, 0.81f, 0.70f}, {0.93f, 0.88f, 0.77f}},  // red, cream
        {{0.13f, 0.26f, 0.50f}, {0.80f, 0.83f, 0.85f}, {0.90f, 0.88f, 0.82f}},  // deep blue, mist
        {{0.83f, 0.60f, 0.15f}, {0.45f, 0.30f, 0.20f}, {0.96f, 0.90f, 0.74f}},  // mustard, walnut
        {{0.45f, 0.56f, 0.44f}, {0.89f, 0.87f, 0.79f}, {0.93f, 0.92f, 0.84f}},  // sage, linen
        {{0.43f, 0.18f, 0.36f}, {0.85f, 0.74f, 0.76f}, {0.92f, 0.82f, 0.80f}},  // plum, rose
        {{0.08f, 0.44f, 0.46f}, {0.93f, 0.80f, 0.62f}, {0.95f, 0.88f, 0.74f}},  // teal, apricot
    }};
    return rows[static_cast<std::size_t>(cloth) % rows.size()];
}

}  // namespace drape
