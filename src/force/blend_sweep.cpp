#include "force/blend_sweep.h"

#include <algorithm>

#include "base/wide.h"
#include "force/colouring.h"

namespace drape {

namespace {

using Four = BlendSweep::Four;

// Roots and quotients take long to arrive and nothing of a triangle can go on without them, so several fours
// go through each stage together.
constexpr size_t block = 8;

struct Stage {
    Lanes edge[3][4];            // a row per triangle
    Lanes squared_area, mean_8;  // D^2, S
    Lanes slope[3], cubed[3];    // dD^2/dQ_k, q_k^3 / L_k0^2
    Lanes tension[3], s;         // t_k, s
};

inline __attribute__((always_inline)) void measure(const Four& t, const double* x, Stage& stage) {
    for (int i = 0; i < 4; ++i) {
        Lanes p[3];
        for (int k = 0; k < 3; ++k) load(p[k], x + t.corner[k][i]);
        for (int k = 0; k < 3; ++k) stage.edge[k][i] = p[(k + 2) % 3] - p[(k + 1) % 3];
    }
    const lanes::Vertices e[3] = {lanes::transposed(stage.edge[0]), lanes::transposed(stage.edge[1]),
                                  lanes::transposed(stage.edge[2])};
    const lanes::Vertices normal = {e[1].y * e[2].z - e[1].z * e[2].y, e[1].z * e[2].x - e[1].x * e[2].z,
                                    e[1].x * e[2].y - e[1].y * e[2].x};
    stage.squared_area = dot(normal, normal);
    const Lanes length_2[3] = {dot(e[0], e[0]), dot(e[1], e[1]), dot(e[2], e[2])};
    Lanes fourth[3];
    for (int k = 0; k < 3; ++k) {
        Lanes w;
        load(w, t.inverse_squared_edge[k]);
        const Lanes q = length_2[k] * w, q_2 = q * q;
        stage.cubed[k] = q_2 * q * w;
        fourth[k] = q_2 * q_2;
        stage.slope[k] = (length_2[(k + 1) % 3] + length_2[(k + 2) % 3] - length_2[k]) / 2;
    }
    stage.mean_8 = (fourth[0] + fourth[1] + fourth[2]) / 3;
}

inline __attribute__((always_inline)) void divide(const Four& t, Stage& stage) {
    const Lanes one = Lanes{} + 1;
    const Lanes safe = stage.mean_8 > 0 ? stage.mean_8 : one;
    const Lanes area = square_root(stage.squared_area);
    const Lanes mean = square_root(square_root(square_root(safe)));
    Lanes inverse_double_area;
    load(inverse_double_area, t.inverse_double_area);
    const Lanes quotient = inverse_double_area / (mean * (area > 0 ? area : one));
    const Lanes by_area = area > 0 ? quotient : Lanes{};  // 1 / (D D0 S^(1/8)); no area, no direction
    stage.s = by_area * stage.squared_area;
    const Lanes by_mean = stage.s / (3 * safe);
    for (int k = 0; k < 3; ++k) stage.tension[k] = by_area * stage.slope[k] - by_mean * stage.cubed[k];
}

// f -= (W (s - 1) + c rate) grad s; returns c rate^2
template <bool damped>
inline __attribute__((always_inline)) Lanes push_apart(const Four& t, const Stage& stage, const double* v,
                                                       double* f) {
    Lanes gradient[3][4], weight, heat = {};
    for (int i = 0; i < 4; ++i) {
        Lanes pull[3];
        for (int k = 0; k < 3; ++k) pull[k] = stage.tension[k][i] * stage.edge[k][i];
        for (int k = 0; k < 3; ++k) gradient[k][i] = pull[(k + 1) % 3] - pull[(k + 2) % 3];
    }
    load(weight, t.weight);
    Lanes push = weight * (stage.s - 1);
    if (damped) {
        Lanes power[4], damping;
        for (int i = 0; i < 4; ++i) {
            Lanes moving[3];
            for (int k = 0; k < 3; ++k) load(moving[k], v + t.corner[k][i]);
            power[i] = gradient[0][i] * moving[0] + gradient[1][i] * moving[1] + gradient[2][i] * moving[2];
        }
        const Lanes rate = lanes::row_sums(power[0], power[1], power[2], power[3]);
        load(damping, t.damping);
        push += damping * rate;
        heat = damping * rate * rate;
    }
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 3; ++k) {
            Lanes sum;
            load(sum, f + t.corner[k][i]);
            store(sum - push[i] * gradient[k][i], f + t.corner[k][i]);
        }
    }
    return heat;
}

template <bool damped>
inline __attribute__((always_inline)) double sweep(const std::vector<Four>& fours, const double* x,
                                                   const double* v, double* f) {
    Stage stage[block];
    Lanes heat = {};
    for (size_t from = 0; from < fours.size(); from += block) {
        const size_t count = std::min(block, fours.size() - from);
        const Four* t = fours.data() + from;
        for (size_t i = 0; i < count; ++i) measure(t[i], x, stage[i]);
        for (size_t i = 0; i < count; ++i) divide(t[i], stage[i]);
        for (size_t i = 0; i < count; ++i) heat += push_apart<damped>(t[i], stage[i], v, f);
    }
    return lane_sum(heat);
}

DRAPE_WIDE void push_triangles(const std::vector<Four>& fours, const double* x, double* f) {
    sweep<false>(fours, x, nullptr, f);
}

DRAPE_WIDE double push_damped_triangles(const std::vector<Four>& fours, const double* x, const double* v,
                                        double* f) {
    return sweep<true>(fours, x, v, f);
}

}  // namespace

BlendSweep::BlendSweep(const blend::Columns& columns, int triangles) {
    std::vector<int> corners;
    for (int i = 0; i < triangles; ++i)
        for (const int* corner : columns.corner) corners.push_back(corner[i]);
    size_t lane = 0;
    for (const int i : spread_elements(corners, 3)) {
        if (lane == 0) fours_.emplace_back();
        Four& four = fours_.back();
        for (size_t k = 0; k < 3; ++k) {
            four.corner[k][lane] = static_cast<std::uint32_t>(4 * columns.corner[k][i]);
            four.inverse_squared_edge[k][lane] = columns.inverse_squared_edge[k][i];
        }
        four.inverse_double_area[lane] = columns.inverse_double_area[i];
        four.weight[lane] = columns.weight[i];
        four.damping[lane] = columns.damping[i];
        lane = (lane + 1) % 4;
    }
}

void BlendSweep::push(const PaddedPoints& x, PaddedPoints& f) const {
    push_triangles(fours_, x.data(), f.data());
}

double BlendSweep::push_damped(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const {
    return push_damped_triangles(fours_, x.data(), v.data(), f.data());
}

}  // namespace drape
