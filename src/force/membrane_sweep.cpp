#include "force/membrane_sweep.h"

#include "base/wide.h"
#include "force/colouring.h"

namespace drape {

namespace {

using Four = MembraneSweep::Four;
using lanes::Vertices;

struct Triangles {
    Lanes row[3][4];  // the edges e_k, a row per triangle
    Vertices edge[3];
    Lanes squared[3];  // Q_k
};

inline __attribute__((always_inline)) void fetch_edges(const Four& t, const double* points,
                                                       Lanes (&row)[3][4]) {
    for (int i = 0; i < 4; ++i) {
        Lanes p[3];
        for (int k = 0; k < 3; ++k) load(p[k], points + t.corner[k][i]);
        for (int k = 0; k < 3; ++k) row[k][i] = p[(k + 2) % 3] - p[(k + 1) % 3];
    }
}

// T times a vector of three
inline __attribute__((always_inline)) void couple(const Four& t, const Lanes (&of)[3], Lanes (&result)[3]) {
    Lanes beside[3];
    for (int k = 0; k < 3; ++k) load(beside[k], t.beside[k]);
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3, last = (k + 2) % 3;
        Lanes diagonal;
        load(diagonal, t.diagonal[k]);
        result[k] = diagonal * of[k] + (beside[last] * of[next] + beside[next] * of[last]);
    }
}

inline __attribute__((always_inline)) void stvk_tension(const Four& t, const Triangles& now,
                                                        Lanes (&tension)[3]) {
    Lanes change[3];
    for (int k = 0; k < 3; ++k) {
        load(change[k], t.squared[k]);
        change[k] = now.squared[k] - change[k];
    }
    couple(t, change, tension);
}

// A triangle without area, such as those that fill up, has no p.
inline __attribute__((always_inline)) void neo_hookean_tension(const Four& t, const Triangles& now,
                                                               const MembraneModuli& moduli,
                                                               Lanes (&tension)[3]) {
    const Vertices &a = now.edge[1], &b = now.edge[2];
    const Vertices normal = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    const Lanes doubled_area = square_root(dot(normal, normal));
    Lanes inverse_double_area;
    load(inverse_double_area, t.inverse_double_area);
    const Lanes push = moduli.kappa * (doubled_area * inverse_double_area - 1) - moduli.mu;
    const Lanes one = Lanes{} + 1;
    const Lanes quotient = push / (2 * (doubled_area > 0 ? doubled_area : one));
    const Lanes by_area = doubled_area > 0 ? quotient : Lanes{};
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3, last = (k + 2) % 3;
        Lanes shape;
        load(shape, t.shape[k]);
        tension[k] = shape + by_area * ((now.squared[next] + now.squared[last] - now.squared[k]) / 2);
    }
}

template <MembraneKind kind, bool damped>
inline __attribute__((always_inline)) double sweep(const std::vector<Four>& fours,
                                                   const MembraneModuli& moduli, const double* x,
                                                   const double* v, double* f) {
    Lanes heat = {};
    for (const Four& t : fours) {
        Triangles now;
        fetch_edges(t, x, now.row);
        for (int k = 0; k < 3; ++k) {
            now.edge[k] = lanes::transposed(now.row[k]);
            now.squared[k] = dot(now.edge[k], now.edge[k]);
        }
        Lanes tension[3];
        if (kind == MembraneKind::stvk)
            stvk_tension(t, now, tension);
        else
            neo_hookean_tension(t, now, moduli, tension);
        if (damped) {
            Lanes moving[3][4], rate[3], viscous[3], relaxation;
            fetch_edges(t, v, moving);
            for (int k = 0; k < 3; ++k) rate[k] = 2 * dot(now.edge[k], lanes::transposed(moving[k]));
            couple(t, rate, viscous);
            load(relaxation, t.relaxation);
            for (int k = 0; k < 3; ++k) tension[k] += relaxation * viscous[k];
            heat += relaxation * (viscous[0] * rate[0] + viscous[1] * rate[1] + viscous[2] * rate[2]) / 2;
        }
        for (int i = 0; i < 4; ++i) {
            Lanes pull[3];
            for (int k = 0; k < 3; ++k) pull[k] = tension[k][i] * now.row[k][i];
            for (int k = 0; k < 3; ++k) {
                Lanes sum;
                load(sum, f + t.corner[k][i]);
                store(sum - (pull[(k + 1) % 3] - pull[(k + 2) % 3]), f + t.corner[k][i]);
            }
        }
    }
    return lane_sum(heat);
}

DRAPE_WIDE void push_stvk(const std::vector<Four>& fours, const MembraneModuli& moduli, const double* x,
                          double* f) {
    sweep<MembraneKind::stvk, false>(fours, moduli, x, nullptr, f);
}

DRAPE_WIDE double push_damped_stvk(const std::vector<Four>& fours, const MembraneModuli& moduli,
                                   const double* x, const double* v, double* f) {
    return sweep<MembraneKind::stvk, true>(fours, moduli, x, v, f);
}

DRAPE_WIDE void push_neo_hookean(const std::vector<Four>& fours, const MembraneModuli& moduli,
                                 const double* x, double* f) {
    sweep<MembraneKind::neo_hookean, false>(fours, moduli, x, nullptr, f);
}

DRAPE_WIDE double push_damped_neo_hookean(const std::vector<Four>& fours, const MembraneModuli& moduli,
                                          const double* x, const double* v, double* f) {
    return sweep<MembraneKind::neo_hookean, true>(fours, moduli, x, v, f);
}

}  // namespace

MembraneSweep::MembraneSweep(const std::vector<MembraneElement>& elements, MembraneKind kind,
                             const MembraneModuli& moduli)
    : kind_(kind), moduli_(moduli) {
    std::vector<int> corners;
    for (const MembraneElement& element : elements)
        corners.insert(corners.end(), element.corner.begin(), element.corner.end());
    size_t lane = 0;
    for (const int i : spread_elements(corners, 3)) {
        const MembraneElement& element = elements[static_cast<size_t>(i)];
        if (lane == 0) fours_.emplace_back();
        Four& four = fours_.back();
        for (int k = 0; k < 3; ++k) {
            four.corner[k][lane] = static_cast<std::uint32_t>(4 * element.corner[static_cast<size_t>(k)]);
            four.squared[k][lane] = element.squared[k];
            four.diagonal[k][lane] = element.coupling(k, k);
            four.beside[k][lane] = element.coupling((k + 1) % 3, (k + 2) % 3);
            four.shape[k][lane] = moduli.mu * element.area * element.trace[k];
        }
        four.inverse_double_area[lane] = 1 / (2 * element.area);
        four.relaxation[lane] = element.relaxation;
        lane = (lane + 1) % 4;
    }
}

void MembraneSweep::push(const PaddedPoints& x, PaddedPoints& f) const {
    const auto push = kind_ == MembraneKind::stvk ? push_stvk : push_neo_hookean;
    push(fours_, moduli_, x.data(), f.data());
}

double MembraneSweep::push_damped(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const {
    const auto push = kind_ == MembraneKind::stvk ? push_damped_stvk : push_damped_neo_hookean;
    return push(fours_, moduli_, x.data(), v.data(), f.data());
}

}  // namespace drape
