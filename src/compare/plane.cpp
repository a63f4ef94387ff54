#include "compare/plane.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "base/wide.h"

namespace drape {

namespace {

// to[i] = the sum of weights[k] from[i + k stride]
DRAPE_WIDE void weigh(const float* from, int stride, std::span<const float> weights, float* to, int count) {
    std::fill_n(to, count, 0.0F);
    for (const float weight : weights) {
        for (int i = 0; i < count; ++i) to[i] += weight * from[i];
        from += stride;
    }
}

}  // namespace

Plane filtered(const Plane& plane, std::span<const float> across, std::span<const float> down) {
    const int r = static_cast<int>(across.size()) / 2, s = static_cast<int>(down.size()) / 2;
    DRAPE_ASSERT(r <= plane.margin && s <= plane.margin);
    const int width = plane.width;
    std::vector<float> rows(static_cast<size_t>(width) * static_cast<size_t>(plane.height + 2 * s));
    const auto passed = [&](int y) {
        return rows.data() + static_cast<size_t>(y + s) * static_cast<size_t>(width);
    };
    for (int y = -s; y < plane.height + s; ++y) weigh(plane.row(y) - r, 1, across, passed(y), width);
    Plane result(width, plane.height, 0);
    for (int y = 0; y < plane.height; ++y) weigh(passed(y - s), width, down, result.row(y), width);
    return result;
}

std::vector<float> gaussian(double sigma, int radius) {
    std::vector<double> weights;
    double sum = 0;
    for (int x = -radius; x <= radius; ++x) {
        weights.push_back(std::exp(-x * x / (2 * sigma * sigma)));
        sum += weights.back();
    }
    std::vector<float> normed;
    for (const double weight : weights) normed.push_back(static_cast<float>(weight / sum));
    return normed;
}

}  // namespace drape
