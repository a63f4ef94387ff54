// The numbers every shader of a frame shares; shaders/frame.glsl declares the same block.
#pragma once

#include "render/camera.h"
#include "render/light.h"

namespace drape {

// std140: only mat4 and vec4, so C++ and GLSL agree byte by byte.
struct FrameUniforms {
    Eigen::Matrix4f to_clip, to_shadow;
    Eigen::Vector4f eye, ray_x, ray_y, ray_z, to_light, light_right, light_up, size, depth, shadow, scene;
};

struct PictureSize {
    int width, height;
};

FrameUniforms frame_uniforms(const View& view, const Light& light, PictureSize picture, int shadow_texels,
                             const Vec3& centre, double radius);

}  // namespace drape
