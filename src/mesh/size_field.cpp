#include "mesh/size_field.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace drape {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr int most_cells = 400;  // of the grid along a side
constexpr int samples = 200;     // along a side, where vertices are counted

double distance_to(const Vec2& p, const std::array<Vec2, 2>& line) {
    const Vec2 along = line[1] - line[0];
    const double square = along.squaredNorm();
    const double at = square > 0 ? std::clamp((p - line[0]).dot(along) / square, 0.0, 1.0) : 0;
    return (p - line[0] - at * along).norm();
}

// Edge lengths on a square grid, straight between its nodes.
class Grid {
public:
    Grid(const Vec2& low, const Vec2& high, double finest, double coarse) : low_(low) {
        cell_ = std::max(finest, (high - low).maxCoeff() / most_cells);
        for (int k = 0; k < 2; ++k) count_[k] = static_cast<int>((high - low)[k] / cell_) + 2;
        edge_ = Eigen::ArrayXXd::Constant(count_[0], count_[1], coarse);
    }

    // at most this at a place, and more around it by `growth` times the distance
    void lower(const Vec2& p, double edge, double growth) {
        const Eigen::Array2d at = (p - low_).array() / cell_;
        const int i = std::clamp(static_cast<int>(at[0]), 0, count_[0] - 2),
                  j = std::clamp(static_cast<int>(at[1]), 0, count_[1] - 2);
        for (int k = 0; k < 4; ++k) {
            double& here = edge_(i + k % 2, j + k / 2);
            here = std::min(here, edge + growth * cell_ * std::hypot(at[0] - i - k % 2, at[1] - j - k / 2));
        }
    }

    // no node over its neighbours by more than `growth` times their distance
    void grade(double growth) {
        for (bool changed = true; changed;) {
            changed = false;
            for (int sweep = 0; sweep < 4; ++sweep)
                for (int a = 0; a < count_[0]; ++a)
                    for (int b = 0; b < count_[1]; ++b)
                        changed |= grade_at(sweep % 2 == 0 ? a : count_[0] - 1 - a,
                                            sweep / 2 == 0 ? b : count_[1] - 1 - b, growth * cell_);
        }
    }

    double operator()(const Vec2& p) const {
        const Eigen::Array2d at = (p - low_).array() / cell_;
        const int i = std::clamp(static_cast<int>(at[0]), 0, count_[0] - 2),
                  j = std::clamp(static_cast<int>(at[1]), 0, count_[1] - 2);
        const double s = std::clamp(at[0] - i, 0.0, 1.0), t = std::clamp(at[1] - j, 0.0, 1.0);
        return (1 - s) * ((1 - t) * edge_(i, j) + t * edge_(i, j + 1)) +
               s * ((1 - t) * edge_(i + 1, j) + t * edge_(i + 1, j + 1));
    }

private:
    bool grade_at(int i, int j, double step) {
        double least = edge_(i, j);
        for (int di = -1; di <= 1; ++di)
            for (int dj = -1; dj <= 1; ++dj) {
                if (i + di < 0 || i + di >= count_[0] || j + dj < 0 || j + dj >= count_[1]) continue;
                least = std::min(
                    least, edge_(i + di, j + dj) + step * (di != 0 && dj != 0 ? std::numbers::sqrt2 : 1));
            }
        // a node is its own neighbour at distance 0 but for the step, which never lowers it
        const bool lower = least < edge_(i, j) * (1 - 1e-12);
        if (lower) edge_(i, j) = least;
        return lower;
    }

    Vec2 low_;
    double cell_ = 1;
    std::array<int, 2> count_{};
    Eigen::ArrayXXd edge_;
};

}  // namespace

SizeField finer_field(const Finer& finer, double coarse, const Vec2& low, const Vec2& high) {
    const double finest = std::min(finer.finest > 0 ? finer.finest : coarse / 4, coarse);
    std::shared_ptr<Grid> grid;
    if (!finer.curved.empty()) {
        grid = std::make_shared<Grid>(low, high, finest, coarse);
        for (const CurvedPlace& place : finer.curved) {
            const double edge = std::clamp(finer.turn / place.curvature, finest, coarse);
            grid->lower(low + place.uv.cwiseProduct(high - low), edge, finer.growth);
        }
        grid->grade(finer.growth);
    }
    return [=, points = finer.points, lines = finer.lines, growth = finer.growth](const Vec2& p) {
        double edge = grid ? std::min((*grid)(p), coarse) : coarse;
        for (const Vec2& q : points) edge = std::min(edge, finest + growth * (p - q).norm());
        for (const auto& line : lines) edge = std::min(edge, finest + growth * distance_to(p, line));
        return edge;
    };
}

double vertices_asked(const SizeField& edge_length, const Vec2& low, const Vec2& high) {
    double sum = 0;
    for (int i = 0; i < samples; ++i)
        for (int j = 0; j < samples; ++j) {
            const Vec2 at(low.x() + (i + 0.5) / samples * (high.x() - low.x()),
                          low.y() + (j + 0.5) / samples * (high.y() - low.y()));
            sum += 1 / std::pow(edge_length(at), 2);
        }
    return sum * (high - low).prod() / (samples * samples);
}

}  // namespace drape
