#include "mesh/poisson_disk.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace drape {

namespace {

using Vec2 = Eigen::Vector2d;

// what thirty tries leave room for: 0.6 A / r^2 points
constexpr double spacing_over_edge = 0.775;
constexpr int tries = 30;  // around a point before it is given up

// uniform in 0 .. 1; the standard's distributions differ from library to library
double uniform(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

class Points2 {
public:
    Points2(const Eigen::Matrix2Xd& border, const SizeField& edge_length)
        : edge_length_(edge_length), low_(border.rowwise().minCoeff()) {
        const Vec2 span = border.rowwise().maxCoeff() - low_;
        double longest = 0;
        for (int i = 0; i < border.cols(); ++i) longest = std::max(longest, edge_length(border.col(i)));
        // at most some million bins, however fine the points
        cell_ = std::max(spacing_over_edge * longest, span.maxCoeff() / 1000);
        columns_ = static_cast<int>(span.x() / cell_) + 1;
        rows_ = static_cast<int>(span.y() / cell_) + 1;
        bins_.resize(static_cast<size_t>(columns_) * static_cast<size_t>(rows_));
        for (int i = 0; i < border.cols(); ++i) add(border.col(i));
    }

    double spacing(const Vec2& p) const { return spacing_over_edge * edge_length_(p); }
    size_t count() const { return place_.size(); }
    const Vec2& operator[](size_t i) const { return place_[i]; }
    double radius(size_t i) const { return radius_[i]; }

    void add(const Vec2& p) {
        bins_[bin(column(p), row(p))].push_back(place_.size());
        place_.push_back(p);
        radius_.push_back(spacing(p));
        largest_ = std::max(largest_, radius_.back());
    }

    bool has_room(const Vec2& p) const {
        const double own = spacing(p), reach = (own + largest_) / 2;
        const int around = static_cast<int>(reach / cell_) + 1;
        const int c = column(p), r = row(p);
        for (int j = std::max(r - around, 0); j <= std::min(r + around, rows_ - 1); ++j)
            for (int i = std::max(c - around, 0); i <= std::min(c + around, columns_ - 1); ++i)
                for (const size_t other : bins_[bin(i, j)]) {
                    const double apart = (own + radius_[other]) / 2;
                    if ((place_[other] - p).squaredNorm() < apart * apart) return false;
                }
        return true;
    }

private:
    int column(const Vec2& p) const {
        return std::clamp(static_cast<int>((p.x() - low_.x()) / cell_), 0, columns_ - 1);
    }
    int row(const Vec2& p) const {
        return std::clamp(static_cast<int>((p.y() - low_.y()) / cell_), 0, rows_ - 1);
    }
    size_t bin(int c, int r) const {
        return static_cast<size_t>(r) * static_cast<size_t>(columns_) + static_cast<size_t>(c);
    }

    const SizeField& edge_length_;
    Vec2 low_;
    double cell_ = 1, largest_ = 0;
    int columns_ = 1, rows_ = 1;
    std::vector<std::vector<size_t>> bins_;
    std::vector<Vec2> place_;
    std::vector<double> radius_;
};

}  // namespace

Eigen::Matrix2Xd poisson_disk(const Eigen::Matrix2Xd& border, const Region& inside,
                              const SizeField& edge_length, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Points2 points(border, edge_length);
    std::vector<size_t> active(points.count());
    for (size_t i = 0; i < active.size(); ++i) active[i] = i;
    while (!active.empty()) {
        const size_t slot = random() % active.size();
        const Vec2 from = points[active[slot]];
        const double near = points.radius(active[slot]);
        bool added = false;
        for (int attempt = 0; attempt < tries && !added; ++attempt) {
            const double across = 4 * uniform(random) - 2, down = 4 * uniform(random) - 2;
            const double squared = across * across + down * down;
            if (squared < 1 || squared > 4) continue;
            const Vec2 p = from + near * Vec2(across, down);
            if (!inside(p) || !points.has_room(p)) continue;
            active.push_back(points.count());
            points.add(p);
            added = true;
        }
        if (!added) {
            active[slot] = active.back();
            active.pop_back();
        }
    }
    Eigen::Matrix2Xd all(2, static_cast<Eigen::Index>(points.count()));
    for (size_t i = 0; i < points.count(); ++i) all.col(static_cast<Eigen::Index>(i)) = points[i];
    return all;
}

}  // namespace drape
