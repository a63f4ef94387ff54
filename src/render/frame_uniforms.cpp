#include "render/frame_uniforms.h"

namespace drape {

namespace {

// half the angle the key light's softbox is seen under: wide enough for soft edges, small enough for form
constexpr double light_tangent = 0.11;
// ambient occlusion looks this far, as a fraction of the scene's radius
constexpr double occlusion_reach = 0.16;

Eigen::Vector4f four(const Vec3& v, double w) {
    return Eigen::Vector4d(v.x(), v.y(), v.z(), w).cast<float>();
}

}  // namespace

FrameUniforms frame_uniforms(const View& view, const Light& light, PictureSize picture, int shadow_texels,
                             const Vec3& centre, double radius) {
    FrameUniforms uniforms;
    uniforms.to_clip = view.to_clip;
    uniforms.to_shadow = light.to_map;
    uniforms.eye = four(view.eye, 1);
    uniforms.ray_x = four(view.right * view.tan_x, 0);
    uniforms.ray_y = four(view.up * view.tan_y, 0);
    uniforms.ray_z = four(view.forward, 0);
    uniforms.to_light = four(light.to_light, light_tangent);
    uniforms.light_right = four(light.right, 0);
    uniforms.light_up = four(light.up, 0);
    uniforms.size = Eigen::Vector4d(picture.width, picture.height, 1.0 / picture.width, 1.0 / picture.height)
                        .cast<float>();
    uniforms.depth =
        Eigen::Vector4d(view.near, view.far, 2 * view.tan_y / picture.height, occlusion_reach * radius)
            .cast<float>();
    uniforms.shadow =
        Eigen::Vector4d(light.width, light.range, light.width / shadow_texels, 1.0 / shadow_texels)
            .cast<float>();
    uniforms.scene = four(centre, radius);
    return uniforms;
}

}  // namespace drape
