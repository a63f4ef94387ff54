// The draped cloth as a small picture: what the renderer's tests look at.
#pragma once

#include "render/palette.h"
#include "render/renderer.h"
#include "support/draped_cloth.h"

namespace drape {

struct SmallPicture {
    Mesh sheet;
    DrawnSolid sphere;
    RenderSettings settings;
    FrameInput frame;

    explicit SmallPicture(int divisions = 32)
        : sheet(make_pattern("alternating", {1, 1, divisions, divisions})) {
        sphere.surface = ball(draped_sphere_radius, 24);
        settings.width = 320;
        settings.height = 180;
        settings.bounds = Eigen::AlignedBox3d(Vec3(-0.5, 0, -0.5), Vec3(0.5, 0.62, 0.5));
        settings.camera.from = Vec3(0.9, 0.8, 1.95);
        settings.camera.at = Vec3(0, 0.29, 0);
        frame.cloth = {draped_over_sphere(sheet)};
        Pose pose;
        pose.translation = draped_sphere_centre;
        frame.solid = {pose};
    }
    Image draw(Backend backend = Backend::osmesa) const {
        return Renderer(settings, {{&sheet, palette(0)}}, {sphere}, backend).draw(frame);
    }
};

inline double brightness(const std::uint8_t* pixel) {
    return (pixel[0] + pixel[1] + pixel[2]) / 3.0;
}

// Pixels that differ in any channel.
inline int pixels_apart(const Image& a, const Image& b) {
    int count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            count += !std::equal(a.pixel(x, y), a.pixel(x, y) + 3, b.pixel(x, y));
    return count;
}

}  // namespace drape
