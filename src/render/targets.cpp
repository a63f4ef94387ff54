#include "render/targets.h"

#include <array>

#include "base/error.h"

namespace drape {

Targets::Targets(const Gl& gl, int width, int height)
    : half_width((width + 1) / 2), half_height((height + 1) / 2) {
    int limit = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (width < 1 || height < 1 || width > limit || height > limit)
        throw Error(cat("picture size must lie between 1 x 1 and ", limit, " x ", limit, ", got ", width,
                        " x ", height));
    constexpr int samples = 4;
    shadow = make_texture(gl, GL_DEPTH_COMPONENT32F, {shadow_texels, shadow_texels});
    depth = make_texture(gl, GL_DEPTH_COMPONENT32F, {width, height});
    seen = make_texture(gl, GL_RGBA8, {width, height});
    occlusion = make_texture(gl, GL_RGBA32F, {half_width, half_height});
    blur = make_texture(gl, GL_RGBA32F, {half_width, half_height});
    colour = make_texture(gl, GL_RGBA8, {width, height});
    keys = make_texture(gl, GL_R32UI, {width, height, samples});
    key_depth = make_texture(gl, GL_DEPTH_COMPONENT32F, {width, height, samples});
    resolved = make_texture(gl, GL_RGBA8, {width, height});
    shadow_frame = make_framebuffer(gl, 0, shadow);
    seen_frame = make_framebuffer(gl, seen, depth);
    occlusion_frame = make_framebuffer(gl, occlusion, 0);
    blur_frame = make_framebuffer(gl, blur, 0);
    colour_frame = make_framebuffer(gl, colour, depth);
    key_frame = make_framebuffer(gl, keys, key_depth);
    resolved_frame = make_framebuffer(gl, resolved, 0);
}

void Targets::clear_seen(const Gl& gl) const {
    constexpr float far = 1;
    constexpr std::array<float, 4> nothing{0.5f, 0.5f, 0, 0};
    gl.ClearNamedFramebufferfv(seen_frame, GL_DEPTH, 0, &far);
    gl.ClearNamedFramebufferfv(seen_frame, GL_COLOR, 0, nothing.data());
}

void Targets::clear_keys(const Gl& gl) const {
    constexpr float far = 1;
    constexpr std::array<GLuint, 4> no_key{0x00FFFFFF, 0, 0, 0};  // key 0 at the far plane
    gl.ClearNamedFramebufferfv(key_frame, GL_DEPTH, 0, &far);
    gl.ClearNamedFramebufferuiv(key_frame, GL_COLOR, 0, no_key.data());
}

}  // namespace drape
