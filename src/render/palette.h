// How the cloths of a scene look, in order.
#pragma once

#include "render/picture.h"

namespace drape {

// In the colours of picture/palette.h.
ClothLook palette(int cloth);

}  // namespace drape
