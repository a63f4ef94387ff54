// A disc that crosses a shaded ground, as numbered pictures: what the tests of videos are made of.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

#include "io/png.h"
#include "io/write_file.h"

namespace drape::test {

inline Image moving_disc(int frame, int width, int height) {
    Image image(width, height);
    const double x0 = 0.2 * width + 0.05 * width * frame, y0 = 0.5 * height, radius = 0.25 * height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double inside = std::fmin(std::fmax(radius + 0.5 - std::hypot(x - x0, y - y0), 0), 1);
            const double ground = 90 + 80.0 * y / height;
            const double disc[3] = {200, 60, 50};
            for (int c = 0; c < 3; ++c)
                image.pixel(x, y)[c] = static_cast<std::uint8_t>(ground + inside * (disc[c] - ground));
        }
    return image;
}

// `folder`/PREFIX0001.png and so on; returns the folder.
inline std::string write_frames(const std::string& folder, int frames, int width = 64, int height = 36,
                                const std::string& prefix = "frame_", int first = 1) {
    make_folder(folder);
    for (int k = 0; k < frames; ++k) {
        char number[16];
        std::snprintf(number, sizeof number, "%04d.png", first + k);
        write_file(folder + "/" + prefix + number, encode_png(moving_disc(k, width, height)));
    }
    return folder;
}

}  // namespace drape::test
