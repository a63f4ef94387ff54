#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "render/renderer.h"

namespace drape {

namespace {

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

}  // namespace

View::View(const Camera& camera, double aspect) : eye(camera.from) {
    const double distance = (camera.at - camera.from).norm();
    if (!(distance > 0)) throw Error("camera: from and at are the same point");
    if (!(camera.fov_deg > 0 && camera.fov_deg < 170))
        throw Error(cat("camera: fov_deg must lie between 0 and 170, got ", camera.fov_deg));
    forward = (camera.at - camera.from) / distance;
    const Vec3 sky = std::abs(forward.y()) > 0.999 ? Vec3(-Vec3::UnitZ()) : Vec3(Vec3::UnitY());
    right = forward.cross(sky).normalized();
    up = right.cross(forward);
    tan_y = std::tan(radians(camera.fov_deg) / 2);
    tan_x = tan_y * aspect;
    near = 0.04 * distance;
    far = 40 * distance;

    Eigen::Matrix4d to_view = Eigen::Matrix4d::Identity(), project = Eigen::Matrix4d::Zero();
    to_view.row(0).head<3>() = right;
    to_view.row(1).head<3>() = up;
    to_view.row(2).head<3>() = -forward;
    to_view.topRightCorner<3, 1>() = -(to_view.topLeftCorner<3, 3>() * eye);
    project(0, 0) = 1 / tan_x;
    project(1, 1) = 1 / tan_y;
    project(2, 2) = -(far + near) / (far - near);
    project(2, 3) = -2 * far * near / (far - near);
    project(3, 2) = -1;
    to_clip = (project * to_view).cast<float>();
}

bool View::misses(const Vec3& centre, double radius) const {
    const Vec3 c = centre - eye;
    const double depth = c.dot(forward);
    if (depth < near - radius) return true;
    return std::abs(c.dot(right)) - depth * tan_x > radius * std::hypot(1.0, tan_x) ||
           std::abs(c.dot(up)) - depth * tan_y > radius * std::hypot(1.0, tan_y);
}

void View::project(const Points& points, Eigen::AlignedBox2d& seen) const {
    for (int i = 0; i < points.cols(); ++i) {
        const Vec3 c = points.col(i) - eye;
        const double depth = c.dot(forward);
        if (!(depth >= near && depth < 1e30)) {
            seen.extend(Eigen::Vector2d(-1, -1));
            seen.extend(Eigen::Vector2d(1, 1));
            return;
        }
        seen.extend(Eigen::Vector2d(c.dot(right) / (depth * tan_x), c.dot(up) / (depth * tan_y)));
    }
}

PixelBox pixels_around(const Eigen::AlignedBox2d& seen, int width, int height) {
    if (seen.isEmpty()) return {};
    const auto pixel = [](double ndc, int size, double beyond) {
        return static_cast<int>(
            std::floor(std::clamp((ndc + 1) / 2 * size + beyond, 0.0, static_cast<double>(size))));
    };
    const int left = pixel(seen.min().x(), width, -1), low = pixel(seen.min().y(), height, -1);
    return {left, low, pixel(seen.max().x(), width, 2) - left, pixel(seen.max().y(), height, 2) - low};
}

Camera frame_automatically(const Eigen::AlignedBox3d& bounds, double aspect) {
    Camera camera;
    const Vec3 centre = bounds.isEmpty() ? Vec3(Vec3::Zero()) : bounds.center();
    const double size = bounds.isEmpty() ? 1 : std::max(bounds.diagonal().norm(), 1e-3);
    // from the front right and a little above
    const Vec3 towards_eye = Vec3(0.50, 0.36, 1.0).normalized();
    const Vec3 right = Vec3::UnitY().cross(towards_eye).normalized(), up = towards_eye.cross(right);
    const double margin = 1.08;
    const double tan_y = std::tan(radians(camera.fov_deg) / 2) / margin, tan_x = tan_y * aspect;

    // Slides sideways and back until the outermost corners touch the margin on both sides. In axes where the
    // picture's four sides are planes through the eye, each side asks only for the extreme corner along it.
    double left = 1e300, rightmost = -1e300, low = 1e300,
           high = -1e300;  // of corner offsets seen from the eye
    const auto extend = [&](const Vec3& corner) {
        const Vec3 c = corner - centre;
        const double x = c.dot(right), y = c.dot(up), toward = c.dot(towards_eye);
        left = std::min(left, x - toward * tan_x);
        rightmost = std::max(rightmost, x + toward * tan_x);
        low = std::min(low, y - toward * tan_y);
        high = std::max(high, y + toward * tan_y);
    };
    if (bounds.isEmpty())
        extend(centre);
    else
        for (int i = 0; i < 8; ++i) extend(bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
    const double back = std::max({(rightmost - left) / (2 * tan_x), (high - low) / (2 * tan_y), 0.55 * size});
    camera.at = centre + right * (0.5 * (left + rightmost)) + up * (0.5 * (low + high));
    camera.from = camera.at + towards_eye * back;
    return camera;
}

}  // namespace drape
