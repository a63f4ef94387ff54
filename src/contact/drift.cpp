#include "contact/drift.h"

#include <algorithm>
#include <cmath>

namespace drape {

// Twice the largest way from the mean one.
template <class Way>
double Drift::spread(Way way) const {
    Vec3 mean = Vec3::Zero();
    double count = 0;
    for (const auto& [first, columns] : ranges_) {
        for (int i = first; i < first + columns; ++i) mean += way(i);
        count += columns;
    }
    mean /= count;
    double largest = 0;
    for (const auto& [first, columns] : ranges_)
        for (int i = first; i < first + columns; ++i) {
            const double square = (way(i) - mean).squaredNorm();
            // one that is no number must not be lost
            if (!(square <= largest)) largest = square;
        }
    return 2 * std::sqrt(largest);
}

double Drift::at(In x) const {
    return spread([&](int i) -> Vec3 { return x.col(i) - from_.col(i); });
}

double Drift::ahead(In x, In v, double time) const {
    return std::max(at(x), spread([&](int i) -> Vec3 { return x.col(i) + time * v.col(i) - from_.col(i); }));
}

double Drift::of(In move) const {
    return spread([&](int i) -> Vec3 { return move.col(i); });
}

}  // namespace drape
