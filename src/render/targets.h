// What a frame is drawn into: textures and the framebuffers around them.
#pragma once

#include "render/gl_objects.h"

namespace drape {

struct Targets {
    static constexpr int shadow_texels = 1536;

    Targets(const Gl& gl, int width, int height);
    // Empties what surfaces are drawn into.
    void clear(const Gl& gl) const;

    int half_width, half_height;
    GlName shadow, depth, seen, occlusion, blur, colour, keys, key_depth, picture;
    GlName shadow_frame, seen_frame, occlusion_frame, blur_frame, colour_frame, key_frame, picture_frame;
};

}  // namespace drape
