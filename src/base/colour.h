// A colour as people give it: sRGB, each part 0..1.
#pragma once

#include <array>

namespace drape {

using Colour = std::array<float, 3>;

}  // namespace drape
