// Where cloth feels obstacles: fixed points spread over its triangles, each standing for a piece of area.
#pragma once

#include <vector>

#include "cloth/model.h"

namespace drape {

// A point of the cloth: weights of up to three vertices, and the area it stands for.
struct ContactPoint {
    int vertex[3];        // columns of the State; unused ones repeat the first, with weight 0
    double weight[3];     // sum 1
    double area;          // [m^2]
    double inverse_mass;  // sum w_i^2 / m_i: how easily a force at the point moves it [1/kg]; pins count as 0
    int corners;          // how many vertices have a weight: 1, 2 or 3
};

// Where the point is, or how fast: of three coordinates per vertex.
inline Vec3 value_at(const ContactPoint& point, const double* x) {
    const auto at = [&](int k) { return Eigen::Map<const Vec3>(x + 3 * point.vertex[k]); };
    if (point.corners == 1) return at(0);
    return point.weight[0] * at(0) + point.weight[1] * at(1) + point.weight[2] * at(2);
}

// The vertices (level 1), and for higher levels the lattice points that cut each edge into `level` parts,
// edges and faces shared. Points that only pinned vertices carry are left out: they cannot move.
std::vector<ContactPoint> contact_points(const Model& model, const Cloth& cloth, int level);

}  // namespace drape
