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

DRAPE_WIDE void extend_ahead(Extent& now, Extent& then, const double* x, const double* from, const double* v,
                             double time, Eigen::Index values) {
    constexpr int lanes = Extent::lanes;
    Extent near = now, far = then;
    Eigen::Index i = 0;
    for (; i + lanes <= values; i += lanes)
        for (int k = 0; k < lanes; ++k) {
            const double way = x[i + k] - from[i + k], ahead = way + time * v[i + k];
            near.low[k] = way < near.low[k] ? way : near.low[k];
            near.high[k] = way > near.high[k] ? way : near.high[k];
            far.low[k] = ahead < far.low[k] ? ahead : far.low[k];
            far.high[k] = ahead > far.high[k] ? ahead : far.high[k];
        }
    for (int k = 0; i < values; ++i, ++k) {
        const double way = x[i] - from[i], ahead = way + time * v[i];
        near.low[k] = std::min(near.low[k], way);
        near.high[k] = std::max(near.high[k], way);
        far.low[k] = std::min(far.low[k], ahead);
        far.high[k] = std::max(far.high[k], ahead);
    }
    now = near;
    then = far;
}

}  // namespace

double Drift::at(In x) const {
    Extent extent;
    for (const auto& [first, columns] : ranges_)
        extend(extent, x.data() + 3 * first, from_.data() + 3 * first, 3 * columns);
    return extent.diagonal();
}

double Drift::ahead(In x, In v, double time) const {
    Extent now, then;
    for (const auto& [first, columns] : ranges_)
        extend_ahead(now, then, x.data() + 3 * first, from_.data() + 3 * first, v.data() + 3 * first, time,
                     3 * columns);
    return std::max(now.diagonal(), then.diagonal());
}

double Drift::of(In move) const {
    Vec3 low = Vec3::Constant(INFINITY), high = Vec3::Constant(-INFINITY);
    for (const auto& [first, columns] : ranges_) {
        low = low.cwiseMin(move.middleCols(first, columns).rowwise().minCoeff());
        high = high.cwiseMax(move.middleCols(first, columns).rowwise().maxCoeff());
    }
    return (high - low).norm();
}

}  // namespace drape
