#include "contact/nearest.h"

#include <algorithm>

namespace drape {

namespace {

void measure(Nearest& nearest, const Vec3& way) {
    nearest.distance = way.norm();
    nearest.normal = nearest.distance > 0 ? Vec3(way / nearest.distance) : Vec3::Zero();
}

void free_place(Nearest& nearest, double w0, double w1, double w2, double w3) {
    double* slope = nearest.slope[nearest.free++];
    slope[0] = w0;
    slope[1] = w1;
    slope[2] = w2;
    slope[3] = w3;
}

}  // namespace

// The plane is cut into the triangle, and strips and wedges outside its edges and corners (Voronoi regions).
Nearest nearest_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const auto at = [&](double u, double v, double w) {
        Nearest nearest{{1, -u, -v, -w}, {}, 0, {}, 0};
        measure(nearest, ap - v * ab - w * ac);
        return nearest;
    };
    const auto on_edge = [&](double u, double v, double w, int from, int to) {
        Nearest nearest = at(u, v, w);
        double slope[4] = {};
        slope[from] = 1;
        slope[to] = -1;
        free_place(nearest, slope[0], slope[1], slope[2], slope[3]);
        return nearest;
    };
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return at(1, 0, 0);
    const Vec3 bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return at(0, 1, 0);
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        const double v = d1 / (d1 - d3);
        return on_edge(1 - v, v, 0, 1, 2);
    }
    const Vec3 cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return at(0, 0, 1);
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        const double w = d2 / (d2 - d6);
        return on_edge(1 - w, 0, w, 1, 3);
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return on_edge(0, 1 - w, w, 2, 3);
    }
    const double sum = va + vb + vc;
    if (!(sum > 0)) {  // no area: the nearest place of its edges
        Nearest best = at(1, 0, 0);
        const auto look = [&](int from, int to, const Vec3& start, const Vec3& side) {
            const double length = side.squaredNorm();
            const double part = length > 0 ? std::clamp(side.dot(p - start) / length, 0.0, 1.0) : 0;
            double weight[3] = {};
            weight[from] += 1 - part;
            weight[to] += part;
            const Nearest other = at(weight[0], weight[1], weight[2]);
            if (other.distance < best.distance) best = other;
        };
        look(0, 1, a, ab);
        look(0, 2, a, ac);
        look(1, 2, b, c - b);
        return best;
    }
    Nearest nearest = at(va / sum, vb / sum, vc / sum);
    // straight from the plane: the normal keeps its digits however near the point is
    const Vec3 up = ab.cross(ac);
    const double height = up.dot(ap), size = up.norm();
    nearest.distance = std::abs(height) / size;
    nearest.normal = height == 0 ? Vec3::Zero() : Vec3((height > 0 ? 1 : -1) / size * up);
    free_place(nearest, 0, 1, -1, 0);
    free_place(nearest, 0, 1, 0, -1);
    return nearest;
}

Nearest nearest_of_edges(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = d - c, w = a - c;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
    const double det = u.cross(v).squaredNorm();
    // the lines' nearest points, then each held on its edge and the other brought opposite it
    double s = det > 0 ? std::clamp((uv * vw - vv * uw) / det, 0.0, 1.0) : 0;
    double t = (uv * s + vw) / vv;
    if (t < 0 || t > 1) {
        t = std::clamp(t, 0.0, 1.0);
        s = std::clamp((uv * t - uw) / uu, 0.0, 1.0);
    }
    Nearest nearest{{1 - s, s, -(1 - t), -t}, {}, 0, {}, 0};
    measure(nearest, w + s * u - t * v);
    const bool apart = det > 1e-10 * uu * vv;  // of parallel edges one place follows the other
    const bool moves_s = s > 0 && s<1, moves_t = t> 0 && t < 1 && (apart || !moves_s);
    if (moves_s) free_place(nearest, -1, 1, 0, 0);
    if (moves_t) free_place(nearest, 0, 0, 1, -1);
    if (moves_s && moves_t) {
        const Vec3 up = u.cross(v);
        const double height = up.dot(w), size = up.norm();
        nearest.distance = std::abs(height) / size;
        nearest.normal = height == 0 ? Vec3::Zero() : Vec3((height > 0 ? 1 : -1) / size * up);
    }
    return nearest;
}

}  // namespace drape
