#include "references/changes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace drape::test {

namespace {

constexpr double millimetre = 1e-3;

Image with_cloth_moved(Moment moment) {
    for (Points& cloth : moment.input.cloth) cloth.row(0).array() += millimetre;
    return picture_of(moment);
}

Image with_camera_moved(Moment moment) {
    moment.drawn.settings.camera.from.x() += 5 * millimetre;
    return picture_of(moment);
}

// 2 % less light from every pixel; levels are those of sRGB (IEC 61966-2-1), where light is about their power
// of 2.2.
Image dimmer(Moment moment) {
    Image image = picture_of(moment);
    for (std::uint8_t& level : image.rgb)
        level = static_cast<std::uint8_t>(std::lround(level * std::pow(0.98, 1 / 2.2)));
    return image;
}

constexpr std::array table{
    Change{"the cloth moved by 1 mm", [](const Moment& moment) { return with_cloth_moved(moment); }},
    Change{"the camera moved by 5 mm", [](const Moment& moment) { return with_camera_moved(moment); }},
    Change{"2 % less light", [](const Moment& moment) { return dimmer(moment); }}};

}  // namespace

Points bumped(const Points& cloth) {
    constexpr double radius = 0.1;  // [m]
    const Vec3 top = cloth.col(cloth.cols() / 2);
    Points moved = cloth;
    for (auto x : moved.colwise()) x.y() += millimetre * std::max(0.0, 1 - (x - top).norm() / radius);
    return moved;
}

std::span<const Change> changes() {
    return table;
}

}  // namespace drape::test
