#include "mesh/orientation.h"

#include <cmath>
#include <limits>

namespace drape {

namespace {

// A number as a sum of doubles, smallest first, none of which overlap: its sign is that of the last. A
// product of two sums has at most twice the product of their parts: 192 for the largest below.
class Sum {
public:
    const double* begin() const { return part_; }
    const double* end() const { return part_ + parts_; }

    // Adds a double exactly.
    void add(double value) {
        int kept = 0;
        for (int i = 0; i < parts_; ++i) {
            const double total = value + part_[i], shift = total - value;
            const double rest = (value - (total - shift)) + (part_[i] - shift);
            if (rest != 0) part_[kept++] = rest;
            value = total;
        }
        parts_ = kept;
        if (value != 0) part_[parts_++] = value;
    }
    int sign() const { return parts_ == 0 ? 0 : (part_[parts_ - 1] > 0 ? 1 : -1); }

private:
    double part_[200];
    int parts_ = 0;
};

Sum difference(double a, double b) {
    Sum sum;
    sum.add(a);
    sum.add(-b);
    return sum;
}

// A product of two doubles is the sum of its rounded value and what fma says is missing.
Sum product(const Sum& a, const Sum& b) {
    Sum sum;
    for (const double p : a)
        for (const double q : b) {
            const double value = p * q;
            sum.add(std::fma(p, q, -value));
            sum.add(value);
        }
    return sum;
}

void subtract(Sum& from, const Sum& sum) {
    for (const double part : sum) from.add(-part);
}

int sign(double value) {
    return (value > 0) - (value < 0);
}

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    Sum side[3][3];
    const Vec3* other[3] = {&b, &c, &d};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) side[i][k] = difference((*other[i])[k], a[k]);
    Sum determinant;
    for (int k = 0; k < 3; ++k) {
        Sum minor = product(side[0][(k + 1) % 3], side[1][(k + 2) % 3]);
        subtract(minor, product(side[0][(k + 2) % 3], side[1][(k + 1) % 3]));
        for (const double part : product(minor, side[2][k])) determinant.add(part);
    }
    return determinant.sign();
}

constexpr double epsilon = std::numeric_limits<double>::epsilon();
// Rounding of differences, products and sums, each half an epsilon, is less than these.
constexpr double bound_in_space = 8 * epsilon, bound_in_plane = 4 * epsilon;

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 p = b - a, q = c - a, r = d - a;
    const double xy = p.x() * q.y(), yx = p.y() * q.x(), yz = p.y() * q.z(), zy = p.z() * q.y(),
                 zx = p.z() * q.x(), xz = p.x() * q.z();
    const double determinant = (yz - zy) * r.x() + (zx - xz) * r.y() + (xy - yx) * r.z();
    const double size = (std::abs(yz) + std::abs(zy)) * std::abs(r.x()) +
                        (std::abs(zx) + std::abs(xz)) * std::abs(r.y()) +
                        (std::abs(xy) + std::abs(yx)) * std::abs(r.z());
    if (std::abs(determinant) > bound_in_space * size) return sign(determinant);
    return size == 0 ? 0 : exact_orientation(a, b, c, d);
}

int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const Eigen::Vector2d p = b - a, q = c - a;
    const double xy = p.x() * q.y(), yx = p.y() * q.x();
    if (std::abs(xy - yx) > bound_in_plane * (std::abs(xy) + std::abs(yx))) return sign(xy - yx);
    Sum determinant = product(difference(b.x(), a.x()), difference(c.y(), a.y()));
    subtract(determinant, product(difference(b.y(), a.y()), difference(c.x(), a.x())));
    return determinant.sign();
}

}  // namespace drape
