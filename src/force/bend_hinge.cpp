#include "force/bend_hinge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "force/bend_plate.h"

namespace drape {

namespace {

struct Dihedral {
    double angle;
    std::array<Vec3, 4> gradient;  // of the angle [1/m]
};

// With e = x1 - x0 and the triangles (x0, x1, x2), (x1, x0, x3), normals N1 = e x (x2 - x0), N2 = (x3 - x0) x
// e: moving x2 along N1 turns its triangle by 1 / height, height = |N1| / |e|, so grad_2 = -|e| N1 / |N1|^2,
// the same for x3; the ends of the edge take what is left by moving and turning invariance.
std::optional<Dihedral> dihedral_of(In x, const int (&v)[4]) {
    const Vec3 x0 = x.col(v[0]), x1 = x.col(v[1]), x2 = x.col(v[2]), x3 = x.col(v[3]);
    const Vec3 e = x1 - x0, n1 = e.cross(x2 - x0), n2 = (x3 - x0).cross(e);
    const double length = e.norm(), s1 = n1.squaredNorm(), s2 = n2.squaredNorm();
    if (length == 0 || s1 == 0 || s2 == 0) return std::nullopt;
    Dihedral d;
    d.angle = std::atan2(n1.cross(n2).dot(e) / length, n1.dot(n2));
    const Vec3 g2 = -length / s1 * n1, g3 = -length / s2 * n2;
    const double along2 = (x2 - x0).dot(e) / (length * length), along3 = (x3 - x0).dot(e) / (length * length);
    d.gradient = {-(1 - along2) * g2 - (1 - along3) * g3, -along2 * g2 - along3 * g3, g2, g3};
    return d;
}

// the difference of two angles, the short way round
double turn(double angle, double rest) {
    return std::remainder(angle - rest, 2 * std::numbers::pi);
}

}  // namespace

BendHinge::BendHinge(const Cloth& cloth) {
    const Mesh& mesh = cloth.mesh;
    for (const Edge& edge : cloth.topology.edges) {
        if (edge.face_count != 2) continue;
        const Vec3 x0 = mesh.rest.col(edge.vertex[0]), x1 = mesh.rest.col(edge.vertex[1]);
        const Vec3 x2 = mesh.rest.col(edge.opposite[0]), x3 = mesh.rest.col(edge.opposite[1]);
        const double areas = ((x1 - x0).cross(x2 - x0).norm() + (x1 - x0).cross(x3 - x0).norm()) / 2;
        Hinge hinge{{edge.vertex[0], edge.vertex[1], edge.opposite[0], edge.opposite[1]},
                    cloth.fabric.bending * (x1 - x0).squaredNorm() / areas,
                    0,
                    {},
                    {}};
        for (const int k : {0, 1}) {
            const Vec3 arm = Vec3(mesh.rest.col(edge.opposite[k])) - x0;
            hinge.foot[k] = arm.dot(x1 - x0) / (x1 - x0).squaredNorm();
            hinge.height[k] = arm.cross(x1 - x0).norm() / (x1 - x0).norm();
        }
        const auto rest = dihedral_of(mesh.rest, hinge.vertex);
        if (!rest) continue;
        hinge.rest_angle = rest->angle;
        for (int& v : hinge.vertex) v += cloth.first;
        hinges_.push_back(hinge);
    }
    StepBound bound(cloth.first + cloth.vertices());
    Points rest(3, cloth.first + cloth.vertices());
    rest.rightCols(cloth.vertices()) = mesh.rest;
    add_bound(rest, bound);
    const double fastest_squared =
        bound.stiffness.tail(cloth.vertices()).cwiseQuotient(cloth.mass).maxCoeff();
    tau_ = bending_relaxation_time(cloth, fastest_squared);
}

double BendHinge::energy(In x) const {
    double energy = 0;
    for (const Hinge& hinge : hinges_)
        if (const auto d = dihedral_of(x, hinge.vertex))
            energy += 0.5 * hinge.stiffness * std::pow(turn(d->angle, hinge.rest_angle), 2);
    return energy;
}

void BendHinge::add_conservative(In x, Out f) const {
    for (const Hinge& hinge : hinges_) {
        const auto d = dihedral_of(x, hinge.vertex);
        if (!d) continue;
        const double moment = hinge.stiffness * turn(d->angle, hinge.rest_angle);
        for (size_t k = 0; k < 4; ++k) f.col(hinge.vertex[k]) -= moment * d->gradient[k];
    }
}

Power BendHinge::add_all(In x, In v, double, Out f) const {
    double dissipated = 0;
    for (const Hinge& hinge : hinges_) {
        const auto d = dihedral_of(x, hinge.vertex);
        if (!d) continue;
        double rate = 0;
        for (size_t k = 0; k < 4; ++k) rate += d->gradient[k].dot(v.col(hinge.vertex[k]));
        const double moment = hinge.stiffness * (turn(d->angle, hinge.rest_angle) + tau_ * rate);
        for (size_t k = 0; k < 4; ++k) f.col(hinge.vertex[k]) -= moment * d->gradient[k];
        dissipated += hinge.stiffness * tau_ * rate * rate;
    }
    return {dissipated, 0};
}

// Row k sums to c |g_k| sum |g_j|, g = grad theta; the part with its second derivative, at most of the order
// of |theta - theta0| |g|^2, is taken with the largest angle pi.
void BendHinge::add_bound(In x, StepBound& bound) const {
    for (const Hinge& hinge : hinges_) {
        const auto d = dihedral_of(x, hinge.vertex);
        if (!d) continue;
        double sum = 0;
        for (const Vec3& g : d->gradient) sum += g.norm();
        const double bent = 1 + std::abs(turn(d->angle, hinge.rest_angle));
        for (size_t k = 0; k < 4; ++k) {
            const double row = hinge.stiffness * d->gradient[k].norm() * sum;
            bound.stiffness[hinge.vertex[k]] += row * bent;
            bound.damping[hinge.vertex[k]] += tau_ * row;
        }
    }
}

void BendHinge::add_couplings(Couplings& couplings) const {
    for (const Hinge& hinge : hinges_) couplings.couple(hinge.vertex);
}

namespace {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12>;

Vec12 stacked(const std::array<Vec3, 4>& gradient) {
    Vec12 g;
    g << gradient[0], gradient[1], gradient[2], gradient[3];
    return g;
}

Mat3 cross_matrix(const Vec3& a) {
    Mat3 m;
    m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return m;
}

// grad theta is the sum over both triangles, of far corner k = 2, 3, of w (x) g with
//   w = (-(1 - a), -a, 1) on (x0, x1, xk),   a = (xk - x0).e / |e|^2,   g = -|e| N / |N|^2,
// so hess theta is the sum of w (x) Dg + g (x) Dw. With b = xk - x0 and N = +-e x b (+ for k = 2):
//   Dg = -(N / |N|^2) (D|e|)' - |e| / |N|^2 (I - 2 N N' / |N|^2) DN,   D|e| = (-e, e, 0) / |e|
//   DN = +-([b - e]x, -[b]x, [e]x),   Dw = (1, -1, 0) (x) Da,
//   Da = ((2 a - 1) e - b, b - 2 a e, e) / |e|^2
// One triangle's share is not symmetric; the sum of both is.
Mat12 dihedral_hessian(In x, const int (&v)[4]) {
    const Vec3 x0 = x.col(v[0]), e = Vec3(x.col(v[1])) - x0;
    const double squared = e.squaredNorm(), length = std::sqrt(squared);
    Mat12 hessian = Mat12::Zero();
    for (const int far : {2, 3}) {
        const double side = far == 2 ? 1 : -1;
        const Vec3 b = Vec3(x.col(v[far])) - x0, normal = side * e.cross(b);
        const double area_squared = normal.squaredNorm(), a = b.dot(e) / squared;
        const Vec3 g = -length / area_squared * normal;
        const Mat3 to_g = -length / area_squared *
                          (Mat3::Identity() - 2 / area_squared * normal * normal.transpose()) * side;
        const Mat3 stretch = -normal / (area_squared * length) * e.transpose();
        const Mat3 dg[] = {to_g * cross_matrix(b - e) - stretch, stretch - to_g * cross_matrix(b),
                           to_g * cross_matrix(e)};
        const Vec3 da[] = {((2 * a - 1) * e - b) / squared, (b - 2 * a * e) / squared, e / squared};
        const double w[] = {a - 1, -a, 1}, moved[] = {1, -1, 0};
        const int corner[] = {0, 1, far};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                hessian.block<3, 3>(3 * corner[i], 3 * corner[j]) +=
                    w[i] * dg[j] + moved[i] * g * da[j].transpose();
    }
    return hessian;
}

}  // namespace

void BendHinge::add_stiffness(In x, BlockMatrix& k) const {
    for (const Hinge& hinge : hinges_) {
        const auto d = dihedral_of(x, hinge.vertex);
        if (!d) continue;
        const Vec12 g = stacked(d->gradient);
        k.add_element(hinge.vertex,
                      hinge.stiffness * (g * g.transpose() + turn(d->angle, hinge.rest_angle) *
                                                                 dihedral_hessian(x, hinge.vertex)));
    }
}

void BendHinge::add_damping(In x, In, double, BlockMatrix& b) const {
    if (tau_ == 0) return;
    for (const Hinge& hinge : hinges_) {
        const auto d = dihedral_of(x, hinge.vertex);
        if (!d) continue;
        const Vec12 g = stacked(d->gradient);
        b.add_element(hinge.vertex, tau_ * hinge.stiffness * g * g.transpose());
    }
}

// As dihedral_of has it, the angle changes by v2 / h2 + v3 / h3 at most, where v_k is how far the corner xk
// moves from its foot (1 - a) x0 + a x1. Its square is at most 2 v2^2 / h2^2 + 2 v3^2 / h3^2, however the
// hinge is folded, while its triangles keep their shape. Three times that covers the angle's second
// derivative too, while the hinge is within a quarter turn of its rest angle.
void BendHinge::add_scaled_majorant(double factor, Majorant& majorant) const {
    for (const Hinge& hinge : hinges_) {
        for (const int k : {0, 1}) {
            const double a = hinge.foot[k], c = 6 * factor * hinge.stiffness / std::pow(hinge.height[k], 2);
            majorant.add_point(std::array{hinge.vertex[0], hinge.vertex[1], hinge.vertex[2 + k]},
                               std::array{a - 1, -a, 1.0}, c);
        }
    }
}

void BendHinge::add_stiffness_majorant(Majorant& k) const {
    add_scaled_majorant(1, k);
}

void BendHinge::add_damping_majorant(Majorant& b) const {
    if (tau_ > 0) add_scaled_majorant(tau_, b);
}

}  // namespace drape
