// Colours for the cloths of a scene, in order.
#pragma once

#include "render/picture.h"

namespace drape {

// Cloth 0 is red with a cream lining, then blue, mustard, sage, plum, teal; round again after that.
ClothLook palette(int cloth);

}  // namespace drape
