#include "render/light.h"

namespace drape {

Light place_light(const View& view, const Vec3& centre, double radius) {
    Light light;
    // in the camera's own compass, so that every view of a scene is lit alike
    Vec3 ahead(view.forward.x(), 0, view.forward.z());
    ahead = ahead.norm() > 1e-6 ? Vec3(ahead.normalized()) : Vec3(view.up.x(), 0, view.up.z()).normalized();
    const Vec3 left = Vec3::UnitY().cross(ahead);
    light.to_light = (0.62 * left - 0.38 * ahead + 1.0 * Vec3::UnitY()).normalized();
    light.right = light.to_light.cross(Vec3::UnitY()).normalized();
    light.up = light.right.cross(light.to_light);

    light.width = 2 * radius;
    light.range = 4 * radius;
    Eigen::Matrix4d to_map = Eigen::Matrix4d::Identity();
    to_map.row(0).head<3>() = light.right / light.width;
    to_map.row(1).head<3>() = light.up / light.width;
    to_map.row(2).head<3>() = -light.to_light / light.range;
    const Vec3 shifted = Vec3::Constant(0.5) - to_map.topLeftCorner<3, 3>() * centre;
    to_map.topRightCorner<3, 1>() = shifted;
    light.to_map = to_map.cast<float>();
    return light;
}

}  // namespace drape
