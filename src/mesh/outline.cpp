#include "mesh/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "mesh/orientation.h"

namespace drape {

namespace {

using Vec2 = Eigen::Vector2d;
using Side = std::pair<Vec2, Vec2>;
using std::numbers::pi;

constexpr int circle_corners = 720;      // that stand for a circle where it is measured
constexpr double sharp = 15 * pi / 180;  // a corner that turns by more stays a vertex [rad]
constexpr int pieces = 50;               // of a side, between which the size field is taken

Curve circle(double diameter) {
    Curve curve{{}, diameter / 2};
    for (int i = 0; i < circle_corners; ++i) {
        const double angle = 2 * pi * i / circle_corners;
        curve.corners.emplace_back(curve.radius * std::cos(angle), curve.radius * std::sin(angle));
    }
    return curve;
}

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// Twice the area to the left.
double doubled_area(const Loop& loop) {
    double sum = 0;
    for (size_t i = 0; i < loop.size(); ++i)
        sum += cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
    return sum;
}

bool is_sharp(const Loop& corners, size_t i) {
    const size_t count = corners.size();
    const Vec2 in = corners[i] - corners[(i + count - 1) % count],
               out = corners[(i + 1) % count] - corners[i];
    return std::abs(std::atan2(cross(in, out), in.dot(out))) > sharp;
}

// From corner `from` on, `count` sides: points as far apart as the size field has it, the last corner not
// included.
void add_chain(const Loop& corners, size_t from, size_t count, const SizeField& edge_length, Loop& loop) {
    // edges up to each of many places along the way
    std::vector<Vec2> way{corners[from % corners.size()]};
    std::vector<double> edges{0};
    const int steps = std::max(1, static_cast<int>(pieces * 8 / (count + 7)));
    for (size_t k = 0; k < count; ++k) {
        const Vec2 a = corners[(from + k) % corners.size()], b = corners[(from + k + 1) % corners.size()];
        for (int i = 0; i < steps; ++i) {
            way.push_back(i + 1 == steps ? b : Vec2(a + (i + 1.0) / steps * (b - a)));
            edges.push_back(edges.back() +
                            (b - a).norm() / steps / edge_length(a + (i + 0.5) / steps * (b - a)));
        }
    }
    const int wanted = std::max(1, static_cast<int>(std::lround(edges.back())));
    size_t at = 0;
    for (int i = 0; i < wanted; ++i) {
        const double here = edges.back() * i / wanted;
        while (at + 2 < edges.size() && edges[at + 1] <= here) ++at;
        const double within = (here - edges[at]) / (edges[at + 1] - edges[at]);
        Vec2 p = way[at] + within * (way[at + 1] - way[at]);
        // a way along an axis is straight to the last bit
        for (int k = 0; k < 2; ++k)
            if (way[at][k] == way[at + 1][k]) p[k] = way[at][k];
        loop.push_back(p);
    }
}

Loop points_along(const Curve& curve, const SizeField& edge_length) {
    std::vector<size_t> kept;
    for (size_t i = 0; i < curve.corners.size() && curve.radius == 0; ++i)
        if (is_sharp(curve.corners, i)) kept.push_back(i);
    Loop loop;
    const size_t count = curve.corners.size();
    if (kept.empty()) kept.push_back(0);
    // fewer than three chains could close a loop of less than a triangle
    while (kept.size() < 3) {
        size_t widest = 0, gap = 0;
        for (size_t k = 0; k < kept.size(); ++k) {
            const size_t next = k + 1 < kept.size() ? kept[k + 1] : kept[0] + count;
            if (next - kept[k] > gap) widest = k, gap = next - kept[k];
        }
        kept.insert(kept.begin() + static_cast<std::ptrdiff_t>(widest) + 1, kept[widest] + gap / 2);
    }
    for (size_t k = 0; k < kept.size(); ++k) {
        const size_t next = k + 1 < kept.size() ? kept[k + 1] : kept[0] + count;
        add_chain(curve.corners, kept[k], next - kept[k], edge_length, loop);
    }
    if (curve.radius > 0)
        for (Vec2& p : loop) p *= curve.radius / p.norm();
    return loop;
}

bool touch(const Side& one, const Side& other) {
    const auto side_of = [](const Side& s, const Vec2& p) { return orientation(s.first, s.second, p); };
    const int a = side_of(one, other.first), b = side_of(one, other.second);
    const int c = side_of(other, one.first), d = side_of(other, one.second);
    if (a * b > 0 || c * d > 0) return false;
    if (a != 0 || b != 0) return true;
    // on one line
    const auto low = [](const Side& s) { return s.first.cwiseMin(s.second); };
    const auto high = [](const Side& s) { return s.first.cwiseMax(s.second); };
    return (low(one).array() <= high(other).array()).all() && (low(other).array() <= high(one).array()).all();
}

std::vector<Side> sides_of(const std::vector<Loop>& loops) {
    std::vector<Side> sides;
    for (const Loop& loop : loops)
        for (size_t i = 0; i < loop.size(); ++i) sides.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
    return sides;
}

void check_corners(const Loop& corners) {
    const size_t count = corners.size();
    if (count < 3) throw Error(cat("an outline needs at least 3 corners, got ", count));
    for (size_t i = 0; i < count; ++i)
        if (!corners[i].allFinite()) throw Error(cat("outline: corner ", i + 1, " is not finite"));
    for (size_t i = 0; i < count; ++i)
        if (corners[i] == corners[(i + 1) % count])
            throw Error(cat("outline: corner ", (i + 1) % count + 1, " stands on the one before it"));
}

// More than the corner that neighbours share.
bool meet(const Side& one, const Side& other) {
    const auto folds_back = [](const Vec2& a, const Vec2& corner, const Vec2& b) {
        return orientation(a, corner, b) == 0 && (a - corner).dot(b - corner) > 0;
    };
    if (one.second == other.first && one.first != other.second)
        return folds_back(one.first, one.second, other.second);
    if (other.second == one.first && other.first != one.second)
        return folds_back(other.first, other.second, one.second);
    return touch(one, other);
}

}  // namespace

Vec2 Outline::low() const {
    Vec2 low = Vec2::Constant(INFINITY);
    for (const Curve& curve : curves)
        for (const Vec2& p : curve.corners) low = low.cwiseMin(p);
    return low;
}

Vec2 Outline::high() const {
    Vec2 high = Vec2::Constant(-INFINITY);
    for (const Curve& curve : curves)
        for (const Vec2& p : curve.corners) high = high.cwiseMax(p);
    return high;
}

Outline rectangle_outline(double width, double depth) {
    const Vec2 half(width / 2, depth / 2);
    return {{{{-half, {half.x(), -half.y()}, half, {-half.x(), half.y()}}}}};
}

Outline disc_outline(double diameter) {
    return {{circle(diameter)}};
}

Outline annulus_outline(double outer, double inner) {
    return {{circle(outer), circle(inner)}};
}

Outline polygon_outline(const Loop& corners) {
    return polygons_outline({corners});
}

Outline polygons_outline(const std::vector<Loop>& loops) {
    Outline outline;
    for (const Loop& loop : loops) {
        check_corners(loop);
        outline.curves.push_back({loop});
    }
    const std::vector<Side> sides = sides_of(loops);
    for (size_t i = 0; i < sides.size(); ++i)
        for (size_t j = i + 1; j < sides.size(); ++j)
            if (meet(sides[i], sides[j]))
                throw Error(cat("outline: the sides after corners ", i + 1, " and ", j + 1,
                                " meet (sides may share their corner only)"));
    return outline;
}

std::vector<Loop> border_points(const Outline& outline, const SizeField& edge_length) {
    std::vector<Loop> loops;
    for (const Curve& curve : outline.curves) loops.push_back(points_along(curve, edge_length));
    return loops;
}

void split(const Curve& curve, Loop& loop, size_t after) {
    Vec2 middle = (loop[after] + loop[(after + 1) % loop.size()]) / 2;
    if (curve.radius > 0) middle *= curve.radius / middle.norm();
    loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(after) + 1, middle);
}

Inside::Inside(const std::vector<Loop>& loops) : Inside(sides_of(loops)) {}

Inside::Inside(std::vector<Side> sides) : sides_(std::move(sides)) {
    double high = -INFINITY;
    low_ = INFINITY;
    for (const auto& [a, b] : sides_) {
        low_ = std::min({low_, a.y(), b.y()});
        high = std::max({high, a.y(), b.y()});
    }
    strips_.resize(sides_.size() + 1);
    strips_per_metre_ = sides_.empty() ? 0 : static_cast<double>(sides_.size()) / (high - low_);
    for (size_t i = 0; i < sides_.size(); ++i) {
        const auto& [a, b] = sides_[i];
        for (size_t s = strip(std::min(a.y(), b.y())); s <= strip(std::max(a.y(), b.y())); ++s)
            strips_[s].push_back(i);
    }
}

size_t Inside::strip(double y) const {
    const double wanted = (y - low_) * strips_per_metre_;
    return static_cast<size_t>(std::clamp(wanted, 0.0, static_cast<double>(strips_.size() - 1)));
}

// Sides that a ray towards +x crosses.
bool Inside::operator()(const Vec2& p) const {
    bool inside = false;
    for (const size_t i : strips_[strip(p.y())]) {
        const auto& [a, b] = sides_[i];
        if ((a.y() > p.y()) == (b.y() > p.y())) continue;
        inside ^= (orientation(a, b, p) > 0) == (b.y() > a.y());
    }
    return inside;
}

double area_between(const std::vector<Loop>& loops) {
    double area = 0;
    for (size_t i = 0; i < loops.size(); ++i) {
        int around = 0;
        for (size_t k = 0; k < loops.size(); ++k) around += k != i && Inside({loops[k]})(loops[i].front());
        area += (around % 2 == 0 ? 0.5 : -0.5) * std::abs(doubled_area(loops[i]));
    }
    return area;
}

}  // namespace drape
