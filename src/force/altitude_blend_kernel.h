// The gradient of the blend's shape s (altitude_blend.h) for blocks of triangles: what its energy, its step
// bound and its projection share.
#pragma once

#include <cmath>

namespace drape::blend {

// triangles are worked on in blocks: fetch the corners, then compute side by side in vector lanes
constexpr int block = 16;

struct Columns {
    const int* corner[3];
    const double* inverse_squared_edge[3];
    const double* inverse_double_area;
    const double* weight;
    const double* damping;
};

// the corners of a block of triangles, coordinate by coordinate
struct Corners {
    alignas(64) double x[3][block], y[3][block], z[3][block];

    // `stride` doubles from one vertex to the next
    template <int stride = 3>
    void fetch(const Columns& t, const double* points, int from, int count) {
        for (int k = 0; k < 3; ++k) {
            for (int i = 0; i < count; ++i) {
                const double* p = points + stride * t.corner[k][from + i];
                x[k][i] = p[0];
                y[k][i] = p[1];
                z[k][i] = p[2];
            }
        }
    }
    // to weighted points
    void add_to(const Columns& t, double* points, int from, int count) const {
        for (int i = 0; i < count; ++i) {
            for (int k = 0; k < 3; ++k) {
                double* p = points + 4 * t.corner[k][from + i];
                p[0] += x[k][i];
                p[1] += y[k][i];
                p[2] += z[k][i];
            }
        }
    }
};

// grad s for a block; returns s in `s`
inline __attribute__((always_inline)) void shape_gradient(const Columns& t, const Corners& p, int from,
                                                          int count, Corners& g, double* s) {
    for (int i = 0; i < count; ++i) {
        // edge k runs from corner k+1 to corner k+2, opposite corner k
        const double e0x = p.x[2][i] - p.x[1][i], e0y = p.y[2][i] - p.y[1][i], e0z = p.z[2][i] - p.z[1][i];
        const double e1x = p.x[0][i] - p.x[2][i], e1y = p.y[0][i] - p.y[2][i], e1z = p.z[0][i] - p.z[2][i];
        const double e2x = p.x[1][i] - p.x[0][i], e2y = p.y[1][i] - p.y[0][i], e2z = p.z[1][i] - p.z[0][i];
        const double nx = e1y * e2z - e1z * e2y, ny = e1z * e2x - e1x * e2z, nz = e1x * e2y - e1y * e2x;
        const double doubled_area = std::sqrt(nx * nx + ny * ny + nz * nz);
        const double w0 = t.inverse_squared_edge[0][from + i], w1 = t.inverse_squared_edge[1][from + i],
                     w2 = t.inverse_squared_edge[2][from + i];
        const double q0 = (e0x * e0x + e0y * e0y + e0z * e0z) * w0;
        const double q1 = (e1x * e1x + e1y * e1y + e1z * e1z) * w1;
        const double q2 = (e2x * e2x + e2y * e2y + e2z * e2z) * w2;
        const double c0 = q0 * q0 * q0, c1 = q1 * q1 * q1, c2 = q2 * q2 * q2;
        const double sum = (c0 * q0 + c1 * q1 + c2 * q2) / 3;
        const double safe_sum = sum > 0 ? sum : 1, safe_area = doubled_area > 0 ? doubled_area : 1;
        const double mean = std::sqrt(std::sqrt(std::sqrt(safe_sum)));
        const double shape = doubled_area * t.inverse_double_area[from + i] / mean;
        const double a = t.inverse_double_area[from + i] / (mean * safe_area);  // grad D = n x e / D
        const double b = shape / (3 * safe_sum);
        const double b0 = b * c0 * w0, b1 = b * c1 * w1, b2 = b * c2 * w2;
        // corner k: area part a (n x e_k), edge part -(b_{k+1} - pull along its two edges)
        g.x[0][i] = a * (ny * e0z - nz * e0y) + b2 * e2x - b1 * e1x;
        g.y[0][i] = a * (nz * e0x - nx * e0z) + b2 * e2y - b1 * e1y;
        g.z[0][i] = a * (nx * e0y - ny * e0x) + b2 * e2z - b1 * e1z;
        g.x[1][i] = a * (ny * e1z - nz * e1y) + b0 * e0x - b2 * e2x;
        g.y[1][i] = a * (nz * e1x - nx * e1z) + b0 * e0y - b2 * e2y;
        g.z[1][i] = a * (nx * e1y - ny * e1x) + b0 * e0z - b2 * e2z;
        g.x[2][i] = a * (ny * e2z - nz * e2y) + b1 * e1x - b0 * e0x;
        g.y[2][i] = a * (nz * e2x - nx * e2z) + b1 * e1y - b0 * e0y;
        g.z[2][i] = a * (nx * e2y - ny * e2x) + b1 * e1z - b0 * e0z;
        s[i] = shape;
    }
}

}  // namespace drape::blend
