#include "compare/ssim.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "compare/pictures.h"

using namespace drape;
using namespace drape::test;

namespace {

double grey_at(const Image& image, int x, int y) {
    const std::uint8_t* rgb =
        image.pixel(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
    return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
}

// The formula of one pixel, window by window, in double precision.
double plainly(const Image& a, const Image& b, int x, int y) {
    double weights = 0, ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
    for (int v = -5; v <= 5; ++v) {
        for (int u = -5; u <= 5; ++u) {
            const double w = std::exp(-(u * u + v * v) / 4.5), p = grey_at(a, x + u, y + v),
                         q = grey_at(b, x + u, y + v);
            weights += w;
            ma += w * p;
            mb += w * q;
            aa += w * p * p;
            bb += w * q * q;
            ab += w * p * q;
        }
    }
    for (double* sum : {&ma, &mb, &aa, &bb, &ab}) *sum /= weights;
    const double c1 = 2.55 * 2.55, c2 = 7.65 * 7.65;
    return (2 * ma * mb + c1) * (2 * (ab - ma * mb) + c2) /
           ((ma * ma + mb * mb + c1) * (aa - ma * ma + bb - mb * mb + c2));
}

}  // namespace

TEST_CASE("structural similarity is its formula pixel by pixel", "[compare]") {
    const Image a = random_picture(70, 30, 1);
    Image b = a;
    for (int y = 5; y < 20; ++y)
        for (int x = 10; x < 40; ++x) b.pixel(x, y)[1] = static_cast<std::uint8_t>(b.pixel(x, y)[1] / 2);
    double sum = 0;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 70; ++x) sum += plainly(a, b, x, y);
    CHECK(ssim(a, b) == Approx(sum / 2100).margin(1e-5));
    CHECK(ssim(a, b) < 0.96);
}

TEST_CASE(
    "the same picture is as similar as can be and an unlike one not at all and a dimmer one hardly less",
    "[compare]") {
    const Image a = random_picture(64, 64, 2);
    CHECK(ssim(a, a) == 1);
    CHECK(std::abs(ssim(a, random_picture(64, 64, 3))) < 0.2);
    Image dim = a;
    for (std::uint8_t& level : dim.rgb) level = static_cast<std::uint8_t>(level * 0.98);
    CHECK(ssim(dim, a) > 0.99);
    CHECK(ssim(Image(), Image()) == 1);
}
