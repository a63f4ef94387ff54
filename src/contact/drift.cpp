#include "contact/drift.h"

#include <algorithm>
#include <cmath>

#include "base/wide.h"

namespace drape {

namespace {

// Least and largest of each coordinate, for four points at a time.
struct Extent {
    static constexpr int lanes = 12;
    double low[lanes], high[lanes];

    Extent() {
        std::fill_n(low, lanes, INFINITY);
        std::fill_n(high, lanes, -INFINITY);
    }
    // of the way between any two of the points, at most
    double diagonal() const {
        double sum = 0;
        for (int c = 0; c < 3; ++c) {
            double least = INFINITY, largest = -INFINITY;
            for (int k = c; k < lanes; k += 3) {
                least = std::min(least, low[k]);
                largest = std::max(largest, high[k]);
            }
            sum += (largest - least) * (largest - least);
        }
        return std::sqrt(sum);
    }
};

DRAPE_WIDE void extend(Extent& extent, const double* x, const double* from, Eigen::Index values) {
    constexpr int lanes = Extent::lanes;
    Extent wide = extent;
    Eigen::Index i = 0;
    for (; i + lanes <= values; i += lanes)
        for (int k = 0; k < lanes; ++k) {
            const double way = x[i + k] - from[i + k];
            wide.low[k] = way < wide.low[k] ? way : wide.low[k];
            wide.high[k] = way > wide.high[k] ? way : wide.high[k];
        }
    for (int k = 0; i < values; ++i, ++k) {
        wide.low[k] = std::min(wide.low[k], x[i] - from[i]);
        wide.high[k] = std::max(wide.high[k], x[i] - from[i]);
    }
    extent = wide;
}

DRAPE_WIDE void extend(Extent& extent, const double* move, Eigen::Index values) {
    constexpr int lanes = Extent::lanes;
    Extent wide = extent;
    Eigen::Index i = 0;
    for (; i + lanes <= values; i += lanes)
        for (int k = 0; k < lanes; ++k) {
            wide.low[k] = move[i + k] < wide.low[k] ? move[i + k] : wide.low[k];
            wide.high[k] = move[i + k] > wide.high[k] ? move[i + k] : wide.high[k];
        }
    for (int k = 0; i < values; ++i, ++k) {
        wide.low[k] = std::min(wide.low[k], move[i]);
        wide.high[k] = std::max(wide.high[k], move[i]);
    }
    extent = wide;
}

}  // namespace

double Drift::at(In x) const {
    Extent extent;
    for (const auto& [first, columns] : ranges_)
        extend(extent, x.data() + 3 * first, from_.data() + 3 * first, 3 * columns);
    return extent.diagonal();
}

double Drift::of(In move) const {
    Extent extent;
    for (const auto& [first, columns] : ranges_) extend(extent, move.data() + 3 * first, 3 * columns);
    return extent.diagonal();
}

}  // namespace drape
