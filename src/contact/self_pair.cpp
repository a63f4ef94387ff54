#include "contact/self_pair.h"

#include <algorithm>
#include <cmath>

namespace drape {

namespace {

using PairVector = Eigen::Matrix<double, 12, 1>;

PairVector flat(const PairPoints& x) {
    return Eigen::Map<const PairVector>(x.data());
}

Vec3 edge_u(const PairPoints& x) {
    return x.col(1) - x.col(0);
}
Vec3 edge_v(const PairPoints& x) {
    return x.col(3) - x.col(2);
}

// of |u x v|^2
PairPoints square_gradient(const PairPoints& x) {
    const Vec3 u = edge_u(x), v = edge_v(x), n = u.cross(v);
    const Vec3 by_u = 2 * v.cross(n), by_v = 2 * n.cross(u);
    PairPoints gradient;
    gradient << -by_u, by_u, -by_v, by_v;
    return gradient;
}

PairMatrix square_hessian(const PairPoints& x) {
    const Vec3 u = edge_u(x), v = edge_v(x);
    const Mat3 eye = Mat3::Identity();
    const Mat3 uu = 2 * (v.squaredNorm() * eye - v * v.transpose());
    const Mat3 vv = 2 * (u.squaredNorm() * eye - u * u.transpose());
    const Mat3 uv = 2 * (2 * u * v.transpose() - v * u.transpose() - u.dot(v) * eye);
    const double end[4] = {-1, 1, -1, 1};
    PairMatrix h;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const Mat3& block = i < 2 && j < 2 ? uu : i >= 2 && j >= 2 ? vv : uv;
            const Mat3 turned = i >= 2 && j < 2 ? Mat3(block.transpose()) : block;
            h.block<3, 3>(3 * i, 3 * j) = end[i] * end[j] * turned;
        }
    return h;
}

// of the distance
PairMatrix distance_hessian(const Nearest& nearest, const PairPoints& x, const PairVector& gradient) {
    PairMatrix h = PairMatrix::Zero();
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            h.block<3, 3>(3 * i, 3 * j) = nearest.weight[i] * nearest.weight[j] * Mat3::Identity();
    Eigen::Matrix<double, 12, 2> f = Eigen::Matrix<double, 12, 2>::Zero();
    Eigen::Matrix<double, 3, 2> way = Eigen::Matrix<double, 3, 2>::Zero();
    const Vec3 r = nearest.distance * nearest.normal;
    for (int k = 0; k < nearest.free; ++k) {
        for (int i = 0; i < 4; ++i) way.col(k) += nearest.slope[k][i] * x.col(i);
        for (int i = 0; i < 4; ++i)
            f.col(k).segment<3>(3 * i) = nearest.weight[i] * way.col(k) + nearest.slope[k][i] * r;
    }
    if (nearest.free == 1) h -= f.col(0) * f.col(0).transpose() / way.col(0).squaredNorm();
    if (nearest.free == 2) {
        const Eigen::Matrix2d d = way.transpose() * way;
        h -= f * d.inverse() * f.transpose();
    }
    return (h - gradient * gradient.transpose()) / nearest.distance;
}

PairVector distance_gradient(const Nearest& nearest) {
    PairVector gradient;
    for (int i = 0; i < 4; ++i) gradient.segment<3>(3 * i) = nearest.weight[i] * nearest.normal;
    return gradient;
}

}  // namespace

PairPoints points_of(const SelfPair& pair, const double* x) {
    PairPoints points;
    for (int i = 0; i < 4; ++i) points.col(i) = Eigen::Map<const Vec3>(x + 3 * pair.vertex[i]);
    return points;
}

Nearest nearest_of(const SelfPair& pair, const PairPoints& x) {
    return pair.edges ? nearest_of_edges(x.col(0), x.col(1), x.col(2), x.col(3))
                      : nearest_to_triangle(x.col(0), x.col(1), x.col(2), x.col(3));
}

double separation(const SelfPair& pair, const double* x) {
    const auto height = [&](int i) { return pair.apart.dot(Eigen::Map<const Vec3>(x + 3 * pair.vertex[i])); };
    const double a = height(0), b = height(1), c = height(2), d = height(3);
    return pair.edges ? std::min(a, b) - std::max(c, d) : a - std::max(b, std::max(c, d));
}

Fade fade_of(const SelfPair& pair, const PairPoints& x) {
    Fade fade;
    if (!pair.edges) return fade;
    fade.square = edge_u(x).cross(edge_v(x)).squaredNorm();
    const double y = fade.square / pair.fading;
    if (y >= 1) return fade;
    const double left = 1 - y;
    fade.part = y * (3 - 3 * y + y * y);
    fade.slope = 3 * left * left;
    fade.bend = -6 * left;
    return fade;
}

double pair_energy(const SelfPair& pair, const Barrier& barrier, const PairPoints& x) {
    const double distance = nearest_of(pair, x).distance;
    if (distance >= barrier.thickness) return 0;
    const double part = fade_of(pair, x).part;
    return part == 0 ? 0 : pair.area * part * barrier.energy(distance);
}

PairPoints fading_force(const SelfPair& pair, const PairPoints& x, const Fade& fade, double energy) {
    return -pair.area * energy * fade.slope / pair.fading * square_gradient(x);
}

// The Hessian of m is m'' / f^2 g g' + m' / f H with g, H those of |u x v|^2: by u the gradient is at most
// 2 |v| |u x v| long, and H has blocks of at most 2 |v|^2, 2 |u|^2 and 8 |u| |v|. Each vertex of an edge has
// the edge's blocks twice.
double fading_stiffness(const SelfPair& pair, const PairPoints& x, const Fade& fade, double energy) {
    if (fade.slope == 0) return 0;
    const double u = edge_u(x).norm(), v = edge_v(x).norm(), most = std::max(u, v);
    const double squares = 4 * most * (u + v) * fade.square / pair.fading;
    const double blocks = 2 * most * most + 8 * u * v;
    return 2 * pair.area * energy / pair.fading * (-fade.bend * squares + fade.slope * blocks);
}

PairMatrix pair_hessian(const SelfPair& pair, const Barrier& barrier, const PairPoints& x) {
    const Nearest nearest = nearest_of(pair, x);
    if (nearest.distance >= barrier.thickness) return PairMatrix::Zero();
    const PairVector gradient = distance_gradient(nearest);
    const double pressure = barrier.pressure(nearest.distance);
    const Fade fade = fade_of(pair, x);
    PairMatrix h = fade.part * (barrier.stiffness(nearest.distance) * gradient * gradient.transpose() -
                                pressure * distance_hessian(nearest, x, gradient));
    if (fade.slope > 0) {
        const PairVector by_square = flat(square_gradient(x)) / pair.fading;
        const PairMatrix mixed = gradient * by_square.transpose();
        h -= pressure * fade.slope * (mixed + mixed.transpose());
        h += barrier.energy(nearest.distance) *
             (fade.bend * by_square * by_square.transpose() + fade.slope / pair.fading * square_hessian(x));
    }
    return pair.area * h;
}

}  // namespace drape
