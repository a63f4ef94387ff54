#include "compare/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "compare/pictures.h"

using namespace drape;
using namespace drape::test;

namespace {

using Colour3 = std::array<double, 3>;
constexpr double pi = std::numbers::pi, degree = 3840 * pi / 180;

// FLIP of one pixel, written down as its authors state it: sums over square kernels, in double precision.
double light(int level) {
    const double v = level / 255.0;
    return v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92;
}

constexpr std::array<Colour3, 3> xyz{{{10135552 / 24577794.0, 8788810 / 24577794.0, 4435075 / 24577794.0},
                                      {2613072 / 12288897.0, 8788810 / 12288897.0, 887015 / 12288897.0},
                                      {1425312 / 73733382.0, 8788810 / 73733382.0, 70074185 / 73733382.0}}};

Colour3 over_white(const Colour3& rgb) {
    Colour3 result{};
    for (size_t i = 0; i < 3; ++i)
        result[i] = (xyz[i][0] * rgb[0] + xyz[i][1] * rgb[1] + xyz[i][2] * rgb[2]) /
                    (xyz[i][0] + xyz[i][1] + xyz[i][2]);
    return result;
}

Colour3 opponent(const Image& image, int x, int y) {
    const std::uint8_t* p =
        image.pixel(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
    const Colour3 c = over_white({light(p[0]), light(p[1]), light(p[2])});
    return {116 * c[1] - 16, 500 * (c[0] - c[1]), 200 * (c[1] - c[2])};
}

Colour3 rgb_of(const Colour3& o) {
    const double y = (o[0] + 16) / 116;
    const Colour3 c{(y + o[1] / 500) * 0.950428545, y, (y - o[2] / 200) * 1.088900371};
    const Colour3 rgb{3.241003275 * c[0] - 1.537398934 * c[1] - 0.498615861 * c[2],
                      -0.969224334 * c[0] + 1.875930071 * c[1] + 0.041554224 * c[2],
                      0.055639423 * c[0] - 0.204011202 * c[1] + 1.057148933 * c[2]};
    return {std::clamp(rgb[0], 0.0, 1.0), std::clamp(rgb[1], 0.0, 1.0), std::clamp(rgb[2], 0.0, 1.0)};
}

Colour3 hunt(const Colour3& rgb) {
    Colour3 f = over_white(rgb);
    const double d = 6.0 / 29;
    for (double& v : f) v = v > d * d * d ? std::cbrt(v) : v / (3 * d * d) + 4.0 / 29;
    const double l = 116 * f[1] - 16;
    return {l, 0.01 * l * 500 * (f[0] - f[1]), 0.01 * l * 200 * (f[1] - f[2])};
}

double hyab(const Colour3& a, const Colour3& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

// the sensitivity of channel c at `square` degrees squared
double sensitivity(size_t c, double square) {
    const auto part = [&](double a, double b) {
        return a * std::sqrt(pi / b) * std::exp(-pi * pi * square / b);
    };
    return c == 0 ? part(1, 0.0047) : c == 1 ? part(1, 0.0053) : part(34.1, 0.04) + part(13.5, 0.025);
}

Colour3 blurred(const Image& image, int x, int y) {
    Colour3 sum{}, weights{};
    for (int v = -10; v <= 10; ++v) {
        for (int u = -10; u <= 10; ++u) {
            const Colour3 o = opponent(image, x + u, y + v);
            for (size_t c = 0; c < 3; ++c) {
                const double w = sensitivity(c, (u * u + v * v) / (degree * degree));
                sum[c] += w * o[c];
                weights[c] += w;
            }
        }
    }
    for (size_t c = 0; c < 3; ++c) sum[c] /= weights[c];
    return sum;
}

// the length of the gradient (or of the second derivatives) of brightness
double feature(const Image& image, int x, int y, bool points) {
    const double sd = 0.5 * 0.082 * degree;
    const auto weight = [&](int u, int v) {
        const double g = std::exp(-(u * u + v * v) / (2 * sd * sd));
        return points ? (u * u / (sd * sd) - 1) * g : -u * g;
    };
    double positive = 0, negative = 0, across = 0, down = 0;
    for (int v = -9; v <= 9; ++v)
        for (int u = -9; u <= 9; ++u) (weight(u, v) > 0 ? positive : negative) += weight(u, v);
    for (int v = -9; v <= 9; ++v) {
        for (int u = -9; u <= 9; ++u) {
            const double w = weight(u, v) / (weight(u, v) > 0 ? positive : -negative);
            across += w * (opponent(image, x + u, y + v)[0] + 16) / 116;
            down += w * (opponent(image, x + v, y + u)[0] + 16) / 116;
        }
    }
    return std::hypot(across, down);
}

double plainly(const Image& a, const Image& b, int x, int y) {
    const double most = std::pow(hyab(hunt({0, 1, 0}), hunt({0, 0, 1})), 0.7);
    const double apart = std::pow(hyab(hunt(rgb_of(blurred(a, x, y))), hunt(rgb_of(blurred(b, x, y)))), 0.7);
    const double knee = 0.4 * most;
    const double colour = apart < knee ? 0.95 / knee * apart : 0.95 + (apart - knee) / (most - knee) * 0.05;
    const double features = std::max(std::abs(feature(a, x, y, false) - feature(b, x, y, false)),
                                     std::abs(feature(a, x, y, true) - feature(b, x, y, true)));
    return std::pow(colour, 1 - std::sqrt(features / std::sqrt(2.0)));
}

}  // namespace

TEST_CASE("FLIP is its formula pixel by pixel across tiles and at borders", "[compare]") {
    Image reference = disc(90, 50, 60, 25, 18);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 90; ++x) reference.pixel(x, y)[2] = static_cast<std::uint8_t>(2 * x);
    Image picture = disc(90, 50, 64, 22, 18);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 90; ++x)
            picture.pixel(x, y)[2] = static_cast<std::uint8_t>(2 * x + (x < 30 ? 0 : 40));
    const ErrorMap map = flip(picture, reference);
    for (int y = 0; y < 50; y += 7) {
        for (int x = 0; x < 90; x += 7) {
            CAPTURE(x, y);
            const float error = map.error[static_cast<size_t>(y * 90 + x)];
            const double expected = plainly(picture, reference, x, y);
            CHECK(error == Approx(expected).margin(2e-3));
        }
    }
    CHECK(map.mean() > 0.02);
}

TEST_CASE("green against blue is the largest error and nothing against itself none", "[compare]") {
    Image green(40, 30), blue(40, 30);
    for (int i = 0; i < 40 * 30; ++i)
        green.rgb[static_cast<size_t>(3 * i + 1)] = blue.rgb[static_cast<size_t>(3 * i + 2)] = 255;
    CHECK(flip(green, blue).mean() == Approx(1).margin(1e-4));
    CHECK(flip(green, green).mean() == 0);
    CHECK(flip(Image(), Image()).mean() == 0);
}

TEST_CASE("an error reaches no further than the eye blurs", "[compare]") {
    const Image reference = plain(120, 80);
    Image picture = reference;
    picture.pixel(60, 40)[1] = 180;
    const ErrorMap map = flip(picture, reference);
    CHECK(map.error[40 * 120 + 60] > 0.05F);
    CHECK(map.error[40 * 120 + 75] == 0);
}
