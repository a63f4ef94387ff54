// What a frame is drawn into: textures and the framebuffers around them.
#pragma once

#include "render/gl_objects.h"

namespace drape {

struct Targets {
    static constexpr int shadow_texels = 1536;

    Targets(const Gl& gl, int width, int height);
    // Empty what surfaces are drawn into.
    void clear_seen(const Gl& gl) const;
    void clear_keys(const Gl& gl) const;

    int half_width, half_height;
    GlName shadow, depth, seen, occlusion, blur, colour, keys, key_depth, resolved;
    GlName shadow_frame, seen_frame, occlusion_frame, blur_frame, colour_frame, key_frame, resolved_frame;
};

}  // namespace drape
