#include "compare/hausdorff.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace drape {

namespace {

// Points halved again and again, across the axis in turn: order[middle] parts those before it from those
// after.
class Tree {
public:
    explicit Tree(const Points& points) : points_(points), order_(static_cast<size_t>(points.cols())) {
        std::iota(order_.begin(), order_.end(), 0);
        halve(0, order_.size(), 0);
    }

    // The squared distance to the nearest point, or anything at most `enough` as soon as one is so near.
    double nearest(const Vec3& x, double enough) const {
        double best = std::numeric_limits<double>::infinity();
        search(x, enough, 0, order_.size(), 0, best);
        return best;
    }

private:
    void halve(size_t begin, size_t end, int axis) {
        if (end - begin < 2) return;
        const size_t middle = begin + (end - begin) / 2;
        const auto at = [&](size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(begin), at(middle), at(end),
                         [&](int a, int b) { return points_(axis, a) < points_(axis, b); });
        halve(begin, middle, (axis + 1) % 3);
        halve(middle + 1, end, (axis + 1) % 3);
    }

    void search(const Vec3& x, double enough, size_t begin, size_t end, int axis, double& best) const {
        if (begin == end || best <= enough) return;
        const size_t middle = begin + (end - begin) / 2;
        const int point = order_[middle];
        best = std::min(best, (points_.col(point) - x).squaredNorm());
        const double beyond = x[axis] - points_(axis, point);
        const int next = (axis + 1) % 3;
        const auto before = [&] { search(x, enough, begin, middle, next, best); };
        const auto after = [&] { search(x, enough, middle + 1, end, next, best); };
        beyond < 0 ? before() : after();
        if (beyond * beyond < best) beyond < 0 ? after() : before();
    }

    const Points& points_;
    std::vector<int> order_;
};

// the largest squared distance of one of `points` from the nearest of `others`, or `least` if that is more
double one_way(const Points& points, const Points& others, double least) {
    const Tree tree(others);
    double most = least;
    for (int i = 0; i < points.cols(); ++i) {
        // most often the point of the same number is near enough to know that this one is not the furthest
        if (i < others.cols() && (points.col(i) - others.col(i)).squaredNorm() <= most) continue;
        most = std::max(most, tree.nearest(points.col(i), most));
    }
    return most;
}

}  // namespace

double hausdorff_distance(const Points& points, const Points& reference) {
    if (points.cols() == 0 && reference.cols() == 0) return 0;
    if (points.cols() == reference.cols() && points == reference) return 0;
    if (points.cols() == 0 || reference.cols() == 0 || !points.allFinite() || !reference.allFinite())
        return std::numeric_limits<double>::infinity();
    return std::sqrt(one_way(reference, points, one_way(points, reference, 0)));
}

}  // namespace drape
