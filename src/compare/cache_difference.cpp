#include "compare/cache_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/assert.h"
#include "compare/hausdorff.h"

namespace drape {

namespace {

double far_or(double squared) {
    return std::isnan(squared) ? std::numeric_limits<double>::infinity() : squared;
}

}  // namespace

CacheDifference cache_difference(const Cache& cache, const Cache& reference) {
    CacheDifference worst;
    const size_t samples = std::min(cache.samples.size(), reference.samples.size());
    for (size_t s = 0; s < samples; ++s) {
        const Points &x = cache.samples[s], &y = reference.samples[s];
        DRAPE_ASSERT(x.cols() == y.cols());
        double sum = 0;
        for (int v = 0; v < x.cols(); ++v) {
            const bool same = x.col(v) == y.col(v) || (!x.col(v).allFinite() && !y.col(v).allFinite());
            const double squared = same ? 0 : far_or((x.col(v) - y.col(v)).squaredNorm());
            sum += squared;
            if (std::sqrt(squared) > worst.most_m) {
                worst.most_m = std::sqrt(squared);
                worst.vertex = v;
            }
        }
        if (sum > 0 && worst.from < 0) worst.from = static_cast<int>(s);
        const double rms = x.cols() > 0 ? std::sqrt(sum / static_cast<double>(x.cols())) : 0;
        worst.rms_each.push_back(rms);
        if (rms > worst.rms_m) {
            worst.rms_m = rms;
            worst.sample = static_cast<int>(s);
        }
    }
    return worst;
}

double largest_hausdorff(const Cache& cache, const Cache& reference) {
    double most = 0;
    for (size_t s = 0; s < std::min(cache.samples.size(), reference.samples.size()); ++s)
        most = std::max(most, hausdorff_distance(cache.samples[s], reference.samples[s]));
    return most;
}

}  // namespace drape
