#include "force/edge_sweep.h"

#include "base/wide.h"
#include "force/colouring.h"

namespace drape {

namespace {

using Four = EdgeSweep::Four;

// what four springs span
inline __attribute__((always_inline)) void spans(const Four& s, const double* points, Lanes (&d)[4]) {
    for (int i = 0; i < 4; ++i) {
        Lanes p, q;
        load(p, points + s.a[i]);
        load(q, points + s.b[i]);
        d[i] = p - q;
    }
}

inline __attribute__((always_inline)) Lanes dots(const Lanes (&a)[4], const Lanes (&b)[4]) {
    return lanes::row_sums(a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3]);
}

inline __attribute__((always_inline)) void add_pull(const Four& s, const Lanes (&d)[4], const Lanes& pull,
                                                    double* f) {
    for (int i = 0; i < 4; ++i) {
        const Lanes force = pull[i] * d[i];
        Lanes sum;
        load(sum, f + s.a[i]);
        store(sum - force, f + s.a[i]);
        load(sum, f + s.b[i]);
        store(sum + force, f + s.b[i]);
    }
}

DRAPE_WIDE void pull_springs(const std::vector<Four>& fours, const double* x, double* f) {
    const Lanes one = Lanes{} + 1;
    for (const Four& s : fours) {
        Lanes d[4], rest_length, stiffness;
        spans(s, x, d);
        load(rest_length, s.rest_length);
        load(stiffness, s.stiffness);
        const Lanes length = square_root(dots(d, d));
        add_pull(s, d, stiffness * (length - rest_length) / (length > 0 ? length : one), f);
    }
}

// the same with damping; returns the power turned to heat
DRAPE_WIDE double pull_damped_springs(const std::vector<Four>& fours, const double* x, const double* v,
                                      double* f) {
    const Lanes one = Lanes{} + 1;
    Lanes heat = {};
    for (const Four& s : fours) {
        Lanes d[4], w[4], rest_length, stiffness, damping;
        spans(s, x, d);
        spans(s, v, w);
        load(rest_length, s.rest_length);
        load(stiffness, s.stiffness);
        load(damping, s.damping);
        const Lanes length = square_root(dots(d, d)), inverse = one / (length > 0 ? length : one);
        const Lanes rate = dots(d, w) * inverse;
        add_pull(s, d, (stiffness * (length - rest_length) + damping * rate) * inverse, f);
        heat += damping * rate * rate;
    }
    return lane_sum(heat);
}

}  // namespace

EdgeSweep::EdgeSweep(const std::vector<Spring>& springs, int first_vertex) {
    std::vector<int> ends;
    ends.reserve(2 * springs.size());
    for (const Spring& spring : springs) ends.insert(ends.end(), {spring.a, spring.b});
    fours_.reserve((springs.size() + 3) / 4);
    size_t lane = 0;
    for (const int i : spread_elements(ends, 2)) {
        const Spring& spring = springs[static_cast<size_t>(i)];
        if (lane == 0) fours_.emplace_back();
        Four& four = fours_.back();
        four.a[lane] = static_cast<std::uint32_t>(4 * (first_vertex + spring.a));
        four.b[lane] = static_cast<std::uint32_t>(4 * (first_vertex + spring.b));
        four.rest_length[lane] = spring.rest_length;
        four.stiffness[lane] = spring.stiffness;
        four.damping[lane] = spring.damping;
        lane = (lane + 1) % 4;
    }
}

void EdgeSweep::pull(const PaddedPoints& x, PaddedPoints& f) const {
    pull_springs(fours_, x.data(), f.data());
}

double EdgeSweep::pull_damped(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const {
    return pull_damped_springs(fours_, x.data(), v.data(), f.data());
}

}  // namespace drape
