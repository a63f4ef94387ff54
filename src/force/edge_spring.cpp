#include "force/edge_spring.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/assert.h"
#include "base/wide.h"
#include "force/edge_projection.h"
#include "force/kinds.h"

namespace drape {

namespace {

// Springs are worked on in blocks: fetch the ends, compute side by side in vector lanes, add to the ends in
// order. The order of additions is that of the springs, whatever the vector width.
constexpr int block = 32;

struct Columns {
    const int* a;
    const int* b;
    const double* rest_length;
    const double* stiffness;
    const double* damping;
};

struct Differences {
    alignas(64) double x[block], y[block], z[block];

    void fetch(const Columns& s, const double* points, int from, int count) {
        for (int i = 0; i < count; ++i) {
            const double* p = points + 3 * s.a[from + i];
            const double* q = points + 3 * s.b[from + i];
            x[i] = p[0] - q[0];
            y[i] = p[1] - q[1];
            z[i] = p[2] - q[2];
        }
    }
};

// Springs come sorted by their first end: its force is kept at hand while it stays the same, or every spring
// would wait for the one before to have stored it.
inline void scatter(const Columns& s, const Differences& d, const double* pull, double* f, int from,
                    int count) {
    for (int i = 0; i < count;) {
        const int a = s.a[from + i];
        double* fa = f + 3 * a;
        double ax = fa[0], ay = fa[1], az = fa[2];
        do {
            double* fb = f + 3 * s.b[from + i];
            const double x = pull[i] * d.x[i], y = pull[i] * d.y[i], z = pull[i] * d.z[i];
            ax -= x;
            ay -= y;
            az -= z;
            fb[0] += x;
            fb[1] += y;
            fb[2] += z;
        } while (++i < count && s.a[from + i] == a);
        fa[0] = ax;
        fa[1] = ay;
        fa[2] = az;
    }
}

DRAPE_WIDE void pull_springs(const Columns& s, int springs, const double* x, double* f) {
    Differences d;
    alignas(64) double pull[block];
    for (int from = 0; from < springs; from += block) {
        const int count = std::min(block, springs - from);
        d.fetch(s, x, from, count);
        for (int i = 0; i < count; ++i) {
            const double length = std::sqrt(d.x[i] * d.x[i] + d.y[i] * d.y[i] + d.z[i] * d.z[i]);
            const double stretch = length - s.rest_length[from + i];
            pull[i] = s.stiffness[from + i] * stretch / (length > 0 ? length : 1);
        }
        scatter(s, d, pull, f, from, count);
    }
}

// the same with damping; returns the power turned to heat
DRAPE_WIDE double pull_damped_springs(const Columns& s, int springs, const double* x, const double* v,
                                      double* f) {
    Differences d, w;
    alignas(64) double pull[block], heat[block];
    double dissipated = 0;
    for (int from = 0; from < springs; from += block) {
        const int count = std::min(block, springs - from);
        d.fetch(s, x, from, count);
        w.fetch(s, v, from, count);
        for (int i = 0; i < count; ++i) {
            const double length = std::sqrt(d.x[i] * d.x[i] + d.y[i] * d.y[i] + d.z[i] * d.z[i]);
            const double inverse = 1 / (length > 0 ? length : 1);
            const double rate = (d.x[i] * w.x[i] + d.y[i] * w.y[i] + d.z[i] * w.z[i]) * inverse;
            const double stretch = length - s.rest_length[from + i];
            pull[i] = (s.stiffness[from + i] * stretch + s.damping[from + i] * rate) * inverse;
            heat[i] = s.damping[from + i] * rate * rate;
        }
        scatter(s, d, pull, f, from, count);
        for (int i = 0; i < count; ++i) dissipated += heat[i];
    }
    return dissipated;
}

}  // namespace

EdgeSprings::EdgeSprings(const std::vector<Spring>& springs, int first_vertex) {
    for (const Spring& spring : springs) {
        a_.push_back(first_vertex + spring.a);
        b_.push_back(first_vertex + spring.b);
        rest_length_.push_back(spring.rest_length);
        stiffness_.push_back(spring.stiffness);
        damping_.push_back(spring.damping);
        damped_ = damped_ || spring.damping > 0;
    }
}

EdgeSprings::~EdgeSprings() = default;

double EdgeSprings::energy(In x) const {
    double energy = 0;
    for (size_t s = 0; s < a_.size(); ++s) {
        const double stretch = (x.col(a_[s]) - x.col(b_[s])).norm() - rest_length_[s];
        energy += 0.5 * stiffness_[s] * stretch * stretch;
    }
    return energy;
}

void EdgeSprings::add_conservative(In x, Out f) const {
    pull_springs({a_.data(), b_.data(), rest_length_.data(), stiffness_.data(), damping_.data()},
                 static_cast<int>(a_.size()), x.data(), f.data());
}

Power EdgeSprings::add_all(In x, In v, double, Out f) const {
    if (!damped_) {
        add_conservative(x, f);
        return {};
    }
    const double dissipated =
        pull_damped_springs({a_.data(), b_.data(), rest_length_.data(), stiffness_.data(), damping_.data()},
                            static_cast<int>(a_.size()), x.data(), v.data(), f.data());
    return {dissipated, 0};
}

// The spring's block is c n n' + c (1 - l0/l)(I - n n'), of norm c in tension; in compression its transverse
// part is negative, which buckles and does not vibrate. A row holds it twice: for itself and for its partner.
void EdgeSprings::add_bound(In, StepBound& bound) const {
    for (size_t s = 0; s < a_.size(); ++s) {
        for (const int end : {a_[s], b_[s]}) {
            bound.stiffness[end] += 2 * stiffness_[s];
            bound.damping[end] += 2 * damping_[s];
        }
    }
}

void EdgeSprings::add_couplings(Couplings& couplings) const {
    for (size_t s = 0; s < a_.size(); ++s) couplings.couple(std::array{a_[s], b_[s]});
}

namespace {

// what acts on the difference of two ends acts on each, and against the other
BlockMatrix::Element between_ends(const Mat3& k) {
    BlockMatrix::Element element(6, 6);
    element << k, -k, -k, k;
    return element;
}

}  // namespace

// grad l = n and grad n = (I - n n') / l, so K = c n n' + c (1 - l0/l) (I - n n').
void EdgeSprings::add_stiffness(In x, BlockMatrix& k) const {
    for (size_t s = 0; s < a_.size(); ++s) {
        const Vec3 along = x.col(a_[s]) - x.col(b_[s]);
        const double length = along.norm();
        if (length == 0 && rest_length_[s] > 0) continue;
        const double across = rest_length_[s] > 0 ? 1 - rest_length_[s] / length : 1;
        const Vec3 n = length > 0 ? Vec3(along / length) : Vec3::Zero();
        k.add_element(
            std::array{a_[s], b_[s]},
            between_ends(stiffness_[s] * (across * Mat3::Identity() + (1 - across) * n * n.transpose())));
    }
}

void EdgeSprings::add_damping(In x, In, double, BlockMatrix& b) const {
    if (!damped_) return;
    for (size_t s = 0; s < a_.size(); ++s) {
        const Vec3 along = x.col(a_[s]) - x.col(b_[s]);
        const double length = along.norm();
        if (length == 0) continue;
        const Vec3 n = along / length;
        b.add_element(std::array{a_[s], b_[s]}, between_ends(damping_[s] * n * n.transpose()));
    }
}

// Along the spring K is c, across it c (1 - l0/l) < c at any length.
void EdgeSprings::add_stiffness_majorant(Majorant& k) const {
    for (size_t s = 0; s < a_.size(); ++s) k.add_difference(a_[s], b_[s], stiffness_[s]);
}

void EdgeSprings::add_damping_majorant(Majorant& b) const {
    for (size_t s = 0; s < a_.size(); ++s) b.add_difference(a_[s], b_[s], damping_[s]);
}

void EdgeSprings::project(WeightedPoints& x, const WeightedPoints& before, double h) {
    if (!projection_)
        projection_ = std::make_unique<EdgeProjection>(a_, b_, rest_length_, stiffness_, damping_);
    projection_->sweep(x, before, h);
}

MadeForce make_edge_springs(const Cloth& cloth, const Surroundings&) {
    if (cloth.network.edges.empty()) return {nullptr, "no edges"};
    if (cloth.fabric.stretch == 0) return {nullptr, "stretch is 0"};
    return {std::make_unique<EdgeSprings>(cloth.network.edges, cloth.first), "along every mesh edge"};
}

}  // namespace drape
