#include "render/colour_map.h"

#include "render/drawables.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape {

namespace {

// Polar CIELAB: magnitude, saturation angle, hue angle [rad].
struct Msh {
    double m, s, h;
};

double to_srgb(double light) {
    light = std::clamp(light, 0.0, 1.0);
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

Colour colour_of(const Msh& c) {
    const double l = c.m * std::cos(c.s), a = c.m * std::sin(c.s) * std::cos(c.h),
                 b = c.m * std::sin(c.s) * std::sin(c.h);
    const double fy = (l + 16) / 116, fx = fy + a / 500, fz = fy - b / 200;
    const auto cube = [](double f) { return f > 6.0 / 29 ? f * f * f : (f - 16.0 / 116) * 3 * 36.0 / 841; };
    const double x = 0.95047 * cube(fx), y = cube(fy), z = 1.08883 * cube(fz);  // D65
    return {static_cast<float>(to_srgb(3.2404542 * x - 1.5371385 * y - 0.4985314 * z)),
            static_cast<float>(to_srgb(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z)),
            static_cast<float>(to_srgb(0.0556434 * x - 0.2040259 * y + 1.0572252 * z))};
}

}  // namespace

Colour diverging_colour(float t) {
    t = std::clamp(t, -1.0f, 1.0f);
    const double strength = std::abs(static_cast<double>(t));
    // ends of the arms, and the hue each starts with beside the grey middle
    const Msh end = t < 0 ? Msh{80, 1.08, -1.1} : Msh{80, 1.08, 0.5};
    const double middle_hue = t < 0 ? -1.66 : 1.06;
    const double middle_m = 88;
    return colour_of({middle_m + (end.m - middle_m) * strength, end.s * strength,
                      middle_hue + (end.h - middle_hue) * strength});
}

Colour rising_colour(float t) {
    const double strength = (std::clamp(static_cast<double>(t), -1.0, 1.0) + 1) / 2;
    const double lightness = 93 - 68 * strength;
    const double chroma = 22 + 52 * std::sin(std::numbers::pi * std::min(strength * 0.85 + 0.05, 1.0));
    return colour_of({std::hypot(lightness, chroma), std::atan2(chroma, lightness), 1.7 - 2.5 * strength});
}

GlName make_colour_texture(const Gl& gl, Colour (*map)(float)) {
    constexpr int texels = 256;
    std::vector<float> light;
    for (int i = 0; i < texels; ++i) {
        const Eigen::Vector3f colour = linear_light(map(2 * (static_cast<float>(i) + 0.5f) / texels - 1));
        light.insert(light.end(), {colour[0], colour[1], colour[2], 1});
    }
    GlName texture = make_texture(gl, GL_RGBA32F, {texels, 1});
    gl.TextureSubImage2D(texture, 0, 0, 0, texels, 1, GL_RGBA, GL_FLOAT, light.data());
    return texture;
}

}  // namespace drape
