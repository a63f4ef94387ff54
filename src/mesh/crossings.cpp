#include "mesh/crossings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "mesh/orientation.h"

namespace drape {

namespace {

struct Triangle {
    Vec3 corner[3];
};

// In one plane, which is looked at along the axis that sees most of it; any axis that sees it edge-on would
// tell nothing.
struct Flat {
    int u, v;
    Eigen::Vector2d operator()(const Vec3& p) const { return {p[u], p[v]}; }
};

Flat flat_view(const Triangle& t) {
    int best = 0;
    double most = -1;
    for (int k = 0; k < 3; ++k) {
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        const Vec3 p = t.corner[1] - t.corner[0], q = t.corner[2] - t.corner[0];
        const double seen = std::abs(p[u] * q[v] - p[v] * q[u]);
        if (seen > most) {
            most = seen;
            best = k;
        }
    }
    return {(best + 1) % 3, (best + 2) % 3};
}

bool lies_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
    return (p.array() >= a.cwiseMin(b).array()).all() && (p.array() <= a.cwiseMax(b).array()).all();
}

bool segments_meet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                   const Eigen::Vector2d& d) {
    const int ac = orientation(a, b, c), ad = orientation(a, b, d);
    const int ca = orientation(c, d, a), cb = orientation(c, d, b);
    if (ac * ad < 0 && ca * cb < 0) return true;
    return (ac == 0 && lies_between(a, b, c)) || (ad == 0 && lies_between(a, b, d)) ||
           (ca == 0 && lies_between(c, d, a)) || (cb == 0 && lies_between(c, d, b));
}

bool holds(const Eigen::Vector2d (&t)[3], const Eigen::Vector2d& p) {
    const int a = orientation(t[0], t[1], p), b = orientation(t[1], t[2], p), c = orientation(t[2], t[0], p);
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

// of a segment in the triangle's plane
bool meets_flat(const Vec3& p, const Vec3& q, const Triangle& t) {
    const Flat flat = flat_view(t);
    const Eigen::Vector2d corner[3] = {flat(t.corner[0]), flat(t.corner[1]), flat(t.corner[2])};
    const Eigen::Vector2d from = flat(p), to = flat(q);
    if (holds(corner, from)) return true;
    for (int k = 0; k < 3; ++k)
        if (segments_meet(from, to, corner[k], corner[(k + 1) % 3])) return true;
    return false;
}

// Whether a segment is clearly beyond one of the triangle's sides, by far more than rounding can hide: so are
// most neighbours in a flat sheet, whose exact signs would all have to be taken at length.
bool is_beside(const Vec3& p, const Vec3& q, const Triangle& t) {
    constexpr double clear = 1e-13;
    const Vec3 one = t.corner[1] - t.corner[0], two = t.corner[2] - t.corner[0], normal = one.cross(two);
    const double area = one.norm() * two.norm();
    for (int k = 0; k < 3; ++k) {
        const Vec3& from = t.corner[k];
        const Vec3 side = t.corner[(k + 1) % 3] - from, out = side.cross(normal);
        const Vec3 to_p = p - from, to_q = q - from;
        const double size =
            clear * side.norm() * area * (to_p.norm() + to_q.norm() + side.norm() + from.norm());
        if (out.dot(to_p) > size && out.dot(to_q) > size) return true;
    }
    return false;
}

// A segment meets a triangle if its ends lie on either side of the plane, or in it, and the triangle's sides
// all turn the same way round its line.
bool meets(const Vec3& p, const Vec3& q, const Triangle& t) {
    if (is_beside(p, q, t)) return false;
    const int above = orientation(t.corner[0], t.corner[1], t.corner[2], p);
    const int below = orientation(t.corner[0], t.corner[1], t.corner[2], q);
    if (above == 0 && below == 0) return meets_flat(p, q, t);
    if (above * below > 0) return false;
    const int a = orientation(p, q, t.corner[0], t.corner[1]),
              b = orientation(p, q, t.corner[1], t.corner[2]);
    if (a * b < 0) return false;
    const int c = orientation(p, q, t.corner[2], t.corner[0]);
    return a * c >= 0 && b * c >= 0;
}

bool any_side_meets(const Triangle& one, const Triangle& two) {
    for (int k = 0; k < 3; ++k)
        if (meets(one.corner[k], one.corner[(k + 1) % 3], two)) return true;
    return false;
}

class Counter {
public:
    using Counts = std::function<bool(int, int)>;
    Counter(const Faces& faces, In x, const Counts& counts) : faces_(faces), x_(x), counts_(counts) {
        found_.crosses.resize(static_cast<size_t>(faces.cols()));
    }

    void look_at(int one, int two) {
        if (!counts_(one, two)) return;
        int shared = 0, corner = -1, other = -1;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                if (faces_(i, one) == faces_(j, two)) {
                    ++shared;
                    corner = i;
                    other = j;
                }
        if (shared > 1) return;
        const Triangle a = triangle(one), b = triangle(two);
        const auto opposite_meets = [](const Triangle& t, int k, const Triangle& met) {
            return meets(t.corner[(k + 1) % 3], t.corner[(k + 2) % 3], met);
        };
        const bool cross = shared == 0 ? any_side_meets(a, b) || any_side_meets(b, a)
                                       : opposite_meets(a, corner, b) || opposite_meets(b, other, a);
        if (!cross) return;
        found_.which.push_back({std::min(one, two), std::max(one, two)});
        found_.crosses[static_cast<size_t>(one)] = found_.crosses[static_cast<size_t>(two)] = true;
    }
    Crossings found() {
        std::sort(found_.which.begin(), found_.which.end());
        found_.pairs = static_cast<int>(found_.which.size());
        if (found_.pairs > 0) found_.first = found_.which.front();
        found_.triangles = static_cast<int>(std::count(found_.crosses.begin(), found_.crosses.end(), true));
        return found_;
    }

private:
    Triangle triangle(int f) const {
        return {{x_.col(faces_(0, f)), x_.col(faces_(1, f)), x_.col(faces_(2, f))}};
    }

    const Faces& faces_;
    Eigen::Ref<const Points> x_;
    const Counts& counts_;
    Crossings found_;
};

struct Box {
    Vec3 low, high;
    int face;
    bool meets(const Box& other) const {
        return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
    }
};

// Pairs of boxes that meet, by halving the set at its median along its longest side and looking at both
// halves with each other: two sets of which no box can meet the other's hull are left at once.
class Halving {
public:
    Halving(std::vector<Box> boxes, Counter& counter) : boxes_(std::move(boxes)), counter_(counter) {
        if (boxes_.empty()) return;
        nodes_.reserve(2 * boxes_.size());
        build(0, static_cast<int>(boxes_.size()));
        within(0);
    }

private:
    static constexpr int few = 4;
    struct Node {
        Box hull;
        int first, last, left = -1, right = -1;
    };

    int build(int first, int last) {
        const int at = static_cast<int>(nodes_.size());
        Box hull = boxes_[static_cast<size_t>(first)];
        for (int i = first + 1; i < last; ++i) {
            hull.low = hull.low.cwiseMin(boxes_[static_cast<size_t>(i)].low);
            hull.high = hull.high.cwiseMax(boxes_[static_cast<size_t>(i)].high);
        }
        nodes_.push_back({hull, first, last});
        if (last - first <= few) return at;
        Eigen::Index axis;
        (hull.high - hull.low).maxCoeff(&axis);
        const int middle = (first + last) / 2;
        std::nth_element(boxes_.begin() + first, boxes_.begin() + middle, boxes_.begin() + last,
                         [axis](const Box& a, const Box& b) {
                             const double left = a.low[axis] + a.high[axis];
                             const double right = b.low[axis] + b.high[axis];
                             return left < right || (left == right && a.face < b.face);
                         });
        const int left = build(first, middle), right = build(middle, last);
        nodes_[static_cast<size_t>(at)].left = left;
        nodes_[static_cast<size_t>(at)].right = right;
        return at;
    }
    const Node& node(int i) const { return nodes_[static_cast<size_t>(i)]; }
    void look_at(const Box& a, const Box& b) {
        if (a.meets(b)) counter_.look_at(a.face, b.face);
    }
    void within(int i) {
        const Node& n = node(i);
        if (n.left < 0) {
            for (int a = n.first; a < n.last; ++a)
                for (int b = a + 1; b < n.last; ++b)
                    look_at(boxes_[static_cast<size_t>(a)], boxes_[static_cast<size_t>(b)]);
            return;
        }
        within(n.left);
        within(n.right);
        between(n.left, n.right);
    }
    void between(int i, int j) {
        const Node &m = node(i), &n = node(j);
        if (!m.hull.meets(n.hull)) return;
        if (m.left < 0 && n.left < 0) {
            for (int a = m.first; a < m.last; ++a)
                for (int b = n.first; b < n.last; ++b)
                    look_at(boxes_[static_cast<size_t>(a)], boxes_[static_cast<size_t>(b)]);
        } else if (n.left < 0 || (m.left >= 0 && m.last - m.first >= n.last - n.first)) {
            between(m.left, j);
            between(m.right, j);
        } else {
            between(i, n.left);
            between(i, n.right);
        }
    }

    std::vector<Box> boxes_;
    std::vector<Node> nodes_;
    Counter& counter_;
};

}  // namespace

Crossings count_crossings(const Faces& faces, In x) {
    return count_crossings(faces, x, [](int, int) { return true; });
}

Crossings count_crossings(const Faces& faces, In x, const std::function<bool(int, int)>& counts) {
    std::vector<Box> boxes;
    boxes.reserve(static_cast<size_t>(faces.cols()));
    for (Eigen::Index f = 0; f < faces.cols(); ++f) {
        const Vec3 a = x.col(faces(0, f)), b = x.col(faces(1, f)), c = x.col(faces(2, f));
        if (!(a + b + c).allFinite()) continue;
        boxes.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), static_cast<int>(f)});
    }
    Counter counter(faces, x, counts);
    Halving(std::move(boxes), counter);
    return counter.found();
}

}  // namespace drape
