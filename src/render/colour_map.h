// Numbers as colours.
#pragma once

#include "render/gl_objects.h"
#include "render/picture.h"

namespace drape {

// Strain: blue squeezed, light grey at rest, red stretched. `t` from -1 to 1, clamped. Diverges evenly to the
// eye: both arms run through Moreland's Msh space (2009), polar CIELAB, towards an unsaturated middle.
Colour diverging_colour(float t);

// Error: pale yellow where it is least, over red to dark violet, evenly darker. `t` from -1 to 1, clamped.
Colour rising_colour(float t);

// A map from -1 to 1 as a row of texels in linear light.
GlName make_colour_texture(const Gl& gl, Colour (*map)(float));

}  // namespace drape
