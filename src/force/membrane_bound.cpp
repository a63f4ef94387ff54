// How stiff a membrane can be: for the step of explicit methods, and for constant matrices.
//
// Second derivatives by the columns a, b of F, in the triangle's plane and across it. With q_k = F g_k and S
// the stress dE/d(C/2), corners i and j of a St. Venant-Kirchhoff triangle meet with
//   A (g_i . S g_j + mu (g_i . g_j) FF' + mu q_j q_i' + lambda q_i q_j')   in the plane,
//   A  g_i . S g_j                                                         across it.
// A neo-Hookean one: let p = kappa (J - 1) - mu, d_k = grad_k J, R the quarter turn of hess J in the plane,
// whose eigenvalues are 1 and -1, and adj C / J what hess J is across it. Then
//   A ((mu I + p R)_ij + kappa d_i d_j')   in the plane,   A g_i . (mu I + p adj C / J) g_j   across it.
// Of S, mu I + p R and mu I + p adj C / J the positive parts are taken: negative ones buckle and do not
// vibrate. A row sums the norms of its blocks.
#include <algorithm>
#include <cmath>

#include "force/membrane.h"

namespace drape {

namespace {

using Mat2 = Eigen::Matrix2d;

// the larger singular value
double norm_of(const Mat2& m) {
    return (std::hypot(m(0, 0) + m(1, 1), m(1, 0) - m(0, 1)) +
            std::hypot(m(0, 0) - m(1, 1), m(0, 1) + m(1, 0))) /
           2;
}

Mat2 positive_part(const Mat2& symmetric) {
    const double mean = symmetric.trace() / 2, half = (symmetric(0, 0) - symmetric(1, 1)) / 2;
    const double reach = std::hypot(half, symmetric(0, 1));
    if (mean - reach >= 0) return symmetric;
    if (mean + reach <= 0) return Mat2::Zero();
    return (mean + reach) / (2 * reach) * (symmetric + (reach - mean) * Mat2::Identity());
}

// F in a frame of the triangle's plane now, its first column along the first axis
Mat2 gradient_of(const Mat2& metric, double area_stretch) {
    Mat2 f = Mat2::Zero();
    const double along = std::sqrt(std::max(metric(0, 0), 0.0));
    if (along > 0)
        f << along, metric(0, 1) / along, 0, area_stretch / along;
    else
        f(0, 1) = std::sqrt(std::max(metric(1, 1), 0.0));
    return f;
}

// Blocks of corners i, j [N/m]
struct Blocks {
    const MembraneElement& element;
    Mat2 f;

    const Vec2& slope(int k) const { return element.slope[static_cast<size_t>(k)]; }
    Mat2 material(const MembraneModuli& m, int i, int j) const {
        const Vec2 &g = slope(i), &h = slope(j), q = f * g, r = f * h;
        return element.area *
               (m.mu * (g.dot(h) * f * f.transpose() + r * q.transpose()) + m.lambda * q * r.transpose());
    }
};

// calls norm(i, j) for the norm of each pair's block; the sums of rows
template <class Norm>
Eigen::Vector3d row_sums(Norm norm) {
    Eigen::Vector3d rows = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
        rows[i] += norm(i, i);
        for (int j = 0; j < i; ++j) {
            const double value = norm(i, j);
            rows[i] += value;
            rows[j] += value;
        }
    }
    return rows;
}

Eigen::Vector3d stvk_rows(const Blocks& blocks, const Mat2& metric, const MembraneModuli& m) {
    const Mat2 strain = (metric - Mat2::Identity()) / 2;
    const Mat2 stress = positive_part(2 * m.mu * strain + m.lambda * strain.trace() * Mat2::Identity());
    return row_sums([&](int i, int j) {
        const double across = blocks.element.area * blocks.slope(i).dot(stress * blocks.slope(j));
        return std::max(std::abs(across), norm_of(blocks.material(m, i, j) + across * Mat2::Identity()));
    });
}

Eigen::Vector3d neo_hookean_rows(const Blocks& blocks, const Mat2& metric, double area_stretch,
                                 const MembraneModuli& m) {
    const double p = area_stretch > 0 ? m.kappa * (area_stretch - 1) - m.mu : 0;
    // mu I + p R has the eigenvalues mu + |p| and mu - |p|
    const double most = m.mu + std::abs(p), least = std::max(m.mu - std::abs(p), 0.0);
    const double alpha = (most + least) / 2, beta = std::copysign((most - least) / 2, p);
    Mat2 adjugate, across = m.mu * Mat2::Identity(), cofactor, turn;
    adjugate << metric(1, 1), -metric(0, 1), -metric(0, 1), metric(0, 0);
    if (area_stretch > 0) across += p / area_stretch * adjugate;
    const Mat2 hanging = positive_part(across);
    cofactor << blocks.f(1, 1), -blocks.f(1, 0), -blocks.f(0, 1), blocks.f(0, 0);
    turn << 0, 1, -1, 0;
    return row_sums([&](int i, int j) {
        const Vec2 &g = blocks.slope(i), &h = blocks.slope(j);
        const Mat2 plane = alpha * g.dot(h) * Mat2::Identity() +
                           beta * (g.x() * h.y() - g.y() * h.x()) * turn +
                           m.kappa * (cofactor * g) * (cofactor * h).transpose();
        return blocks.element.area * std::max(std::abs(g.dot(hanging * h)), norm_of(plane));
    });
}

// C from the edges: a, b = the sums of g_k x_k
Mat2 metric_of(const MembraneElement& element, const MembranePose& pose) {
    Mat2 metric = Mat2::Zero();
    for (size_t k = 0; k < 3; ++k) {
        const Mat2 product = element.slope[(k + 1) % 3] * element.slope[(k + 2) % 3].transpose();
        metric -= pose.squared[static_cast<int>(k)] / 2 * (product + product.transpose());
    }
    return metric;
}

}  // namespace

void Membrane::add_bound(In x, StepBound& bound) const {
    for (const MembraneElement& element : elements_) {
        const MembranePose pose = membrane_pose(element, x);
        const Mat2 metric = metric_of(element, pose);
        const double area_stretch = pose.doubled_area / (2 * element.area);
        const Blocks blocks{element, gradient_of(metric, area_stretch)};
        const Eigen::Vector3d stiffness = kind_ == MembraneKind::stvk
                                              ? stvk_rows(blocks, metric, moduli_)
                                              : neo_hookean_rows(blocks, metric, area_stretch, moduli_);
        for (int k = 0; k < 3; ++k) bound.stiffness[element.corner[static_cast<size_t>(k)]] += stiffness[k];
        if (!damped_) continue;
        const Eigen::Vector3d damping = element.relaxation * row_sums([&](int i, int j) {
                                            return norm_of(blocks.material(moduli_, i, j));
                                        });
        for (int k = 0; k < 3; ++k) bound.damping[element.corner[static_cast<size_t>(k)]] += damping[k];
    }
}

// A |dF|^2 = sum A g_i . g_j dx_i . dx_j, and at rest no second derivative by F is above
// 2 max(kappa, mu) |dF|^2. Twice that covers both materials where no stretch s has s^2 > 5/3 and no area is
// below a half:
//   St. Venant-Kirchhoff: at most s^2 of it from the strain's change, (s^2 - 1) / 2 of it from the stress
//   neo-Hookean, with m = max(kappa, mu) and p between -mu - kappa/2 and 2/3 kappa - mu: by changes of s1 and
//   s2
//     mu + kappa s^2 + |kappa (2 J - 1) - mu|, by shear mu + |p|, across at most mu + max(p, 0) s^2: all are
//     at most 4 m
// Of a damped one, tau times the first, twice it where s^2 <= 2.
void Membrane::add_scaled_laplacian(const MembraneElement& element, double factor, Majorant& majorant) {
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j <= i; ++j)
            majorant.add_entry(element.corner[i], element.corner[j],
                               factor * element.area * element.slope[i].dot(element.slope[j]));
}

void Membrane::add_stiffness_majorant(Majorant& k) const {
    const double most = 4 * std::max(moduli_.kappa, moduli_.mu);
    for (const MembraneElement& element : elements_) add_scaled_laplacian(element, most, k);
}

void Membrane::add_damping_majorant(Majorant& b) const {
    if (!damped_) return;
    const double most = 4 * std::max(moduli_.kappa, moduli_.mu);
    for (const MembraneElement& element : elements_)
        add_scaled_laplacian(element, element.relaxation * most, b);
}

}  // namespace drape
