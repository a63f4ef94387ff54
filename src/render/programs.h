// Every shader program of a frame.
#pragma once

#include "render/shader.h"

namespace drape {

struct Programs {
    explicit Programs(const Gl& gl);
    // in the order a frame uses them
    Program shadow, geometry, occlusion, blur, backdrop, ground, solid, cloth, key, resolve, line;
};

}  // namespace drape
