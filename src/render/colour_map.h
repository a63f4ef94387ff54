// Strain as colour: blue squeezed, light grey at rest, red stretched.
#pragma once

#include "render/gl_objects.h"
#include "render/picture.h"

namespace drape {

// `t` from -1 to 1, clamped. Diverges evenly to the eye: both arms run through Moreland's Msh space (2009),
// polar CIELAB, towards an unsaturated middle.
Colour diverging_colour(float t);

// The map from -1 to 1 as a row of texels in linear light.
GlName make_colour_texture(const Gl& gl);

}  // namespace drape
