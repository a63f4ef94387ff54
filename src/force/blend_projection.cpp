#include "force/blend_projection.h"

#include <algorithm>

#include "base/wide.h"
#include "force/colouring.h"

namespace drape {

using namespace blend;

namespace {

DRAPE_WIDE void project(const Columns& t, const std::vector<int>& start, double* x, const double* before,
                        double inverse_h) {
    Corners p, q, g;
    alignas(64) double s[block], weight[3][block];
    for (size_t colour = 0; colour + 1 < start.size(); ++colour) {
        for (int from = start[colour]; from < start[colour + 1]; from += block) {
            const int count = std::min(block, start[colour + 1] - from);
            p.fetch<4>(t, x, from, count);
            q.fetch<4>(t, before, from, count);
            for (int k = 0; k < 3; ++k)
                for (int i = 0; i < count; ++i) weight[k][i] = x[4 * t.corner[k][from + i] + 3];
            shape_gradient(t, p, from, count, g, s);
            for (int i = 0; i < count; ++i) {
                double change = 0, inverse_mass = 0;
                for (int k = 0; k < 3; ++k) {
                    change += g.x[k][i] * (p.x[k][i] - q.x[k][i]) + g.y[k][i] * (p.y[k][i] - q.y[k][i]) +
                              g.z[k][i] * (p.z[k][i] - q.z[k][i]);
                    inverse_mass += weight[k][i] *
                                    (g.x[k][i] * g.x[k][i] + g.y[k][i] * g.y[k][i] + g.z[k][i] * g.z[k][i]);
                }
                const double damping = t.damping[from + i] * inverse_h;
                s[i] = -(t.weight[from + i] * (s[i] - 1) + damping * change) /
                       (inverse_h * inverse_h + inverse_mass * (t.weight[from + i] + damping));
            }
            for (int k = 0; k < 3; ++k)
                for (int i = 0; i < count; ++i) weight[k][i] *= s[i];
            for (int k = 0; k < 3; ++k) {
                for (int i = 0; i < count; ++i) {
                    g.x[k][i] *= weight[k][i];
                    g.y[k][i] *= weight[k][i];
                    g.z[k][i] *= weight[k][i];
                }
            }
            g.add_to(t, x, from, count);
        }
    }
}

}  // namespace

BlendProjection::BlendProjection(const Columns& columns, int triangles) {
    std::vector<int> corners;
    for (int i = 0; i < triangles; ++i)
        for (const int* corner : columns.corner) corners.push_back(corner[i]);
    const Colouring colouring = colour_elements(corners, 3);
    start_ = colouring.start;
    for (const int i : colouring.order) {
        for (int k = 0; k < 3; ++k) {
            corner_[k].push_back(columns.corner[k][i]);
            inverse_squared_edge_[k].push_back(columns.inverse_squared_edge[k][i]);
        }
        inverse_double_area_.push_back(columns.inverse_double_area[i]);
        weight_.push_back(columns.weight[i]);
        damping_.push_back(columns.damping[i]);
    }
}

void BlendProjection::sweep(WeightedPoints& x, const WeightedPoints& before, double h) const {
    const Columns columns{
        {corner_[0].data(), corner_[1].data(), corner_[2].data()},
        {inverse_squared_edge_[0].data(), inverse_squared_edge_[1].data(), inverse_squared_edge_[2].data()},
        inverse_double_area_.data(),
        weight_.data(),
        damping_.data()};
    project(columns, start_, x.data(), before.data(), 1 / h);
}

}  // namespace drape
