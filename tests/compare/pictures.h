// Pictures that tests compare.
#pragma once

#include <random>

#include "base/image.h"

namespace drape::test {

inline Image plain(int width, int height, std::uint8_t level = 100) {
    Image image(width, height);
    for (std::uint8_t& value : image.rgb) value = level;
    return image;
}

// Every channel of every pixel at random, the same for the same seed.
inline Image random_picture(int width, int height, unsigned seed) {
    Image image(width, height);
    std::minstd_rand random(seed);
    for (std::uint8_t& value : image.rgb) value = static_cast<std::uint8_t>(random() >> 8);
    return image;
}

// A white disc on black, antialiased: each pixel as bright as the share of 8 x 8 points in it that are
// inside.
inline Image disc(int width, int height, double x, double y, double radius) {
    Image image(width, height);
    for (int v = 0; v < height; ++v) {
        for (int u = 0; u < width; ++u) {
            int inside = 0;
            for (int k = 0; k < 64; ++k) {
                const double across = u + (k % 8 + 0.5) / 8 - x, down = v + (k / 8 + 0.5) / 8 - y;
                inside += across * across + down * down < radius * radius;
            }
            for (int c = 0; c < 3; ++c) image.pixel(u, v)[c] = static_cast<std::uint8_t>(inside * 255 / 64);
        }
    }
    return image;
}

}  // namespace drape::test
