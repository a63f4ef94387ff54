// Colours as an eye's opponent channels and as a uniform scale of differences have them.
#pragma once

#include "base/image.h"
#include "compare/plane.h"

namespace drape {

// A tile's colours in three channels, light to dark, red to green, blue to yellow:
//   Y = 116 y - 16, Cx = 500 (x - y), Cz = 200 (y - z)
// where x, y, z are CIE XYZ over those of white (D65). Linear in light, so that they may be blurred.
struct Opponent {
    Plane y, cx, cz;
};

// Of an sRGB picture; beyond its border its outermost pixels are repeated.
Opponent opponent_colours(const Image& image, const Tile& tile, int margin);

// The same in CIE L*a*b* with a and b times L / 100, the Hunt effect: colours look weaker where it is dark.
// Clamped to what sRGB can show. In place; the planes become L, a, b.
void to_hunt_lab(Opponent& colours);

}  // namespace drape
