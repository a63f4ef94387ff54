#include "render/palette.h"

#include "picture/palette.h"

namespace drape {

ClothLook palette(int cloth) {
    const ClothPalette colours = cloth_palette(cloth);
    ClothLook look;
    look.front = colours.front;
    look.back = colours.back;
    look.stripe = colours.stripe;
    return look;
}

}  // namespace drape
