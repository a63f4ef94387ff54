#include "force/edge_projection.h"

#include <array>
#include <cmath>

#include "base/lanes.h"
#include "base/wide.h"
#include "force/colouring.h"

namespace drape {

namespace {

// Four springs of a colour are worked on side by side: a vertex is loaded as one vector (x, y, z, w), four of
// them are transposed. By columns of three doubles the same sweep took 1.4 times as long.
using Four = Lanes;

struct Columns {
    const int* a;
    const int* b;
    const double* rest_length;
    const double* stiffness;
    const double* damping;
};

struct Step {
    double inverse;          // 1 / h [1/s]
    double inverse_squared;  // [1/s^2]
};

template <bool damped>
inline __attribute__((always_inline)) void project_four(const Columns& s, int i, double* x,
                                                        const double* before, const Step& step) {
    Four pa[4], pb[4], d[4], dx, dy, dz, wa, wb, rate{}, length, damping{};
    for (int k = 0; k < 4; ++k) {
        load(pa[k], x + 4 * s.a[i + k]);
        load(pb[k], x + 4 * s.b[i + k]);
        d[k] = pa[k] - pb[k];
        dx[k] = d[k][0];
        dy[k] = d[k][1];
        dz[k] = d[k][2];
        wa[k] = x[4 * s.a[i + k] + 3];
        wb[k] = x[4 * s.b[i + k] + 3];
    }
    if (damped) {
        Four qx, qy, qz;
        for (int k = 0; k < 4; ++k) {
            Four qa, qb;
            load(qa, before + 4 * s.a[i + k]);
            load(qb, before + 4 * s.b[i + k]);
            const Four change = d[k] - (qa - qb);
            qx[k] = change[0];
            qy[k] = change[1];
            qz[k] = change[2];
        }
        load(damping, s.damping + i);
        damping *= step.inverse;
        rate = dx * qx + dy * qy + dz * qz;
    }
    const Four squared = dx * dx + dy * dy + dz * dz;
    for (int k = 0; k < 4; ++k) length[k] = std::sqrt(squared[k]);
    const Four safe = length > 0 ? length : Four{1, 1, 1, 1};
    Four rest, stiffness;
    load(rest, s.rest_length + i);
    load(stiffness, s.stiffness + i);
    const Four below = step.inverse_squared + (wa + wb) * (stiffness + damping);
    // h^2 f / l
    const Four pull = damped ? (stiffness * (length - rest) * safe + damping * rate) / (safe * safe * below)
                             : stiffness * (length - rest) / (safe * below);
    const Four move_a = pull * wa, move_b = pull * wb;
    for (int k = 0; k < 4; ++k) {
        const Four a{move_a[k], move_a[k], move_a[k], 0}, b{move_b[k], move_b[k], move_b[k], 0};
        pa[k] -= a * d[k];
        pb[k] += b * d[k];
        store(pa[k], x + 4 * s.a[i + k]);
        store(pb[k], x + 4 * s.b[i + k]);
    }
}

inline __attribute__((always_inline)) void project_one(const Columns& s, int i, double* x,
                                                       const double* before, const Step& step) {
    double *pa = x + 4 * s.a[i], *pb = x + 4 * s.b[i];
    const double *qa = before + 4 * s.a[i], *qb = before + 4 * s.b[i];
    const double d[3] = {pa[0] - pb[0], pa[1] - pb[1], pa[2] - pb[2]};
    double squared = 0, rate = 0;
    for (int c = 0; c < 3; ++c) {
        squared += d[c] * d[c];
        rate += d[c] * (d[c] - (qa[c] - qb[c]));
    }
    const double length = std::sqrt(squared), safe = length > 0 ? length : 1;
    const double damping = s.damping[i] * step.inverse;
    const double below = step.inverse_squared + (pa[3] + pb[3]) * (s.stiffness[i] + damping);
    const double pull =
        (s.stiffness[i] * (length - s.rest_length[i]) * safe + damping * rate) / (safe * safe * below);
    for (int c = 0; c < 3; ++c) {
        const double a = pull * pa[3] * d[c], b = pull * pb[3] * d[c];
        pa[c] -= a;
        pb[c] += b;
    }
}

// A colour's last one to three springs are taken one by one: which ones is the same at every vector width.
template <bool damped>
inline __attribute__((always_inline)) void project_colours(const Columns& s, const std::vector<int>& start,
                                                           double* x, const double* before,
                                                           const Step& step) {
    for (size_t colour = 0; colour + 1 < start.size(); ++colour) {
        int i = start[colour];
        for (; i + 4 <= start[colour + 1]; i += 4) project_four<damped>(s, i, x, before, step);
        for (; i < start[colour + 1]; ++i) project_one(s, i, x, before, step);
    }
}

DRAPE_WIDE void project(const Columns& s, const std::vector<int>& start, double* x, const double* before,
                        const Step& step) {
    project_colours<false>(s, start, x, before, step);
}

DRAPE_WIDE void project_damped(const Columns& s, const std::vector<int>& start, double* x,
                               const double* before, const Step& step) {
    project_colours<true>(s, start, x, before, step);
}

}  // namespace

EdgeProjection::EdgeProjection(const std::vector<int>& a, const std::vector<int>& b,
                               const std::vector<double>& rest_length, const std::vector<double>& stiffness,
                               const std::vector<double>& damping) {
    std::vector<int> ends;
    for (size_t i = 0; i < a.size(); ++i) ends.insert(ends.end(), {a[i], b[i]});
    const Colouring colouring = colour_elements(ends, 2);
    start_ = colouring.start;
    for (const int element : colouring.order) {
        const auto i = static_cast<size_t>(element);
        a_.push_back(a[i]);
        b_.push_back(b[i]);
        rest_length_.push_back(rest_length[i]);
        stiffness_.push_back(stiffness[i]);
        damping_.push_back(damping[i]);
        damped_ = damped_ || damping[i] > 0;
    }
}

void EdgeProjection::sweep(WeightedPoints& x, const WeightedPoints& before, double h) const {
    const Columns s{a_.data(), b_.data(), rest_length_.data(), stiffness_.data(), damping_.data()};
    (damped_ ? project_damped : project)(s, start_, x.data(), before.data(), {1 / h, 1 / (h * h)});
}

}  // namespace drape
