#include "contact/drift.h"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
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

Drift::Drift(std::vector<std::pair<int, int>> ranges) : ranges_(std::move(ranges)) {
    constexpr int enough = 256;
    int columns = 0;
    for (const auto& range : ranges_) columns += range.second;
    const int stride = 1 + columns / enough;
    for (const auto& [first, count] : ranges_)
        for (int i = first; i < first + count; i += stride) some_.push_back(i);
}

template <class Way>
double Drift::spread(Way way) const {
    Vec3 low = Vec3::Constant(INFINITY), high = -low;
    for (const auto& [first, columns] : ranges_)
        for (int i = first; i < first + columns; ++i) {
            const Vec3 left = way(i);
            low = low.cwiseMin(left);
            high = high.cwiseMax(left);
        }
    return (high - low).norm();
}

bool Drift::is_within(In x, double limit) const {
    Extent extent;
    for (const auto& [first, columns] : ranges_)
        extend(extent, x.data() + 3 * first, from_.data() + 3 * first, 3 * columns);
    if (extent.diagonal() <= limit) return true;
    if (!(limit > 0)) return false;
    const Mat3 turn = turn_to(x);
    return spread([&](int i) { return Vec3(x.col(i) - turn * from_.col(i)); }) <= limit;
}

double Drift::of(In move) const {
    Extent extent;
    for (const auto& [first, columns] : ranges_) extend(extent, move.data() + 3 * first, 3 * columns);
    return extent.diagonal();
}

// Turning as one body shrinks no distance, and moving on straight shrinks none faster than at first.
double Drift::rate(In x, In v) const {
    const Vec3 angular = spin(x, v);
    return spread([&](int i) { return Vec3(v.col(i) - angular.cross(x.col(i))); });
}

Vec3 Drift::middle_of(In x) const {
    Vec3 sum = Vec3::Zero();
    for (const int i : some_) sum += x.col(i);
    return sum / static_cast<double>(some_.size());
}

Mat3 Drift::turn_to(In x) const {
    const Vec3 middle = middle_of(x), before = middle_of(from_);
    Mat3 both = Mat3::Zero();
    for (const int i : some_) both += (x.col(i) - middle) * (from_.col(i) - before).transpose();
    if (!both.allFinite()) return Mat3::Identity();
    const Eigen::JacobiSVD<Mat3> svd(both, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Mat3 turned = svd.matrixU() * svd.matrixV().transpose();
    if (turned.determinant() > 0) return turned;
    return svd.matrixU() * Vec3(1, 1, -1).asDiagonal() * svd.matrixV().transpose();
}

Vec3 Drift::spin(In x, In v) const {
    const Vec3 middle = middle_of(x);
    Mat3 inertia = Mat3::Zero();
    Vec3 momentum = Vec3::Zero();
    for (const int i : some_) {
        const Vec3 arm = x.col(i) - middle;
        inertia += arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose();
        momentum += arm.cross(v.col(i));
    }
    const Vec3 angular = inertia.ldlt().solve(momentum);
    return angular.allFinite() ? angular : Vec3::Zero();
}

}  // namespace drape
