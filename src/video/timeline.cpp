#include "video/timeline.h"

#include <algorithm>
#include <cmath>

namespace drape {

std::vector<int> play_order(int frames, bool boomerang, int loops) {
    std::vector<int> order;
    for (int loop = 0; loop < loops; ++loop) {
        for (int k = 0; k < frames; ++k) order.push_back(k);
        for (int k = frames - 2; boomerang && k > 0; --k) order.push_back(k);
    }
    return order;
}

std::vector<int> thinned(const std::vector<int>& order, double rate, double most) {
    if (rate <= most) return order;
    const double stride = rate / most;
    const auto shown =
        std::max<size_t>(1, static_cast<size_t>(std::lround(static_cast<double>(order.size()) / stride)));
    std::vector<int> left;
    for (size_t k = 0; k < shown; ++k) {
        const auto at = static_cast<size_t>(static_cast<double>(k) * stride);
        left.push_back(order[std::min(at, order.size() - 1)]);
    }
    return left;
}

}  // namespace drape
