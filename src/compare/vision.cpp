#include "compare/vision.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/points.h"
#include "base/wide.h"

namespace drape {

namespace {

using Matrix = std::array<std::array<float, 3>, 3>;

Matrix floats(const Mat3& m) {
    Matrix rows{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            rows[static_cast<size_t>(i)][static_cast<size_t>(j)] = static_cast<float>(m(i, j));
    return rows;
}

// linear sRGB to XYZ over white's: with the primaries of sRGB, each row divided by its sum, which is white's
Mat3 to_xyz() {
    Mat3 m;
    m << 10135552, 8788810, 4435075, 2613072, 8788810, 887015, 1425312, 8788810, 70074185;
    for (int i = 0; i < 3; ++i) m.row(i) /= m.row(i).sum();
    return m;
}

// XYZ over white's to Y + 16, Cx, Cz
Mat3 to_opponent() {
    Mat3 m;
    m << 0, 116, 0, 500, -500, 0, 0, 200, -200;
    return m;
}

// light of a level, 0 to 1 (IEC 61966-2-1)
std::array<float, 256> light_of_levels() {
    std::array<float, 256> light{};
    for (size_t level = 0; level < light.size(); ++level) {
        const double v = static_cast<double>(level) / 255;
        light[level] = static_cast<float>(v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92);
    }
    return light;
}

// Newton's iteration from a guess whose exponent is a third: three rounds are as exact as a float. `x` is not
// negative. Unlike the library's, it can be worked on for several pixels side by side.
inline __attribute__((always_inline)) float cube_root(float x) {
    float root = std::bit_cast<float>(std::bit_cast<std::int32_t>(x) / 3 + 0x2a514067);
    for (int round = 0; round < 3; ++round) root = (2 * root + x / (root * root)) / 3;
    return root;
}

// CIE's compression of light: the cube root, a straight line below (6/29)^3
inline __attribute__((always_inline)) float compressed(float x) {
    constexpr float d = 6.0F / 29;
    const float line = x / (3 * d * d) + 4.0F / 29, root = cube_root(std::max(x, d * d * d));
    return x > d * d * d ? root : line;
}

inline __attribute__((always_inline)) float unit(float x) {
    return std::min(std::max(x, 0.0F), 1.0F);
}

DRAPE_WIDE void hunt_lab(float* y, float* cx, float* cz, int count, const Matrix& back, const Matrix& xyz) {
    for (int i = 0; i < count; ++i) {
        const float a = y[i] + 16, b = cx[i], c = cz[i];
        const float red = unit(back[0][0] * a + back[0][1] * b + back[0][2] * c);
        const float green = unit(back[1][0] * a + back[1][1] * b + back[1][2] * c);
        const float blue = unit(back[2][0] * a + back[2][1] * b + back[2][2] * c);
        const float u = compressed(xyz[0][0] * red + xyz[0][1] * green + xyz[0][2] * blue);
        const float v = compressed(xyz[1][0] * red + xyz[1][1] * green + xyz[1][2] * blue);
        const float w = compressed(xyz[2][0] * red + xyz[2][1] * green + xyz[2][2] * blue);
        const float light = 116 * v - 16;
        y[i] = light;
        cx[i] = 0.01F * light * 500 * (u - v);
        cz[i] = 0.01F * light * 200 * (v - w);
    }
}

}  // namespace

Opponent opponent_colours(const Image& image, const Tile& tile, int margin) {
    static const std::array<float, 256> light = light_of_levels();
    static const Matrix m = floats(to_opponent() * to_xyz());
    const Plane empty(tile.width(), tile.height(), margin);
    Opponent colours{empty, empty, empty};
    for (int y = -margin; y < empty.height + margin; ++y) {
        const int v = std::clamp(tile.top + y, 0, image.height - 1);
        float *to_y = colours.y.row(y), *to_cx = colours.cx.row(y), *to_cz = colours.cz.row(y);
        for (int x = -margin; x < empty.width + margin; ++x) {
            const std::uint8_t* rgb = image.pixel(std::clamp(tile.left + x, 0, image.width - 1), v);
            const float red = light[rgb[0]], green = light[rgb[1]], blue = light[rgb[2]];
            to_y[x] = m[0][0] * red + m[0][1] * green + m[0][2] * blue - 16;
            to_cx[x] = m[1][0] * red + m[1][1] * green + m[1][2] * blue;
            to_cz[x] = m[2][0] * red + m[2][1] * green + m[2][2] * blue;
        }
    }
    return colours;
}

void to_hunt_lab(Opponent& colours) {
    static const Matrix xyz = floats(to_xyz()), back = floats((to_opponent() * to_xyz()).inverse());
    hunt_lab(colours.y.values.data(), colours.cx.values.data(), colours.cz.values.data(),
             static_cast<int>(colours.y.values.size()), back, xyz);
}

}  // namespace drape
