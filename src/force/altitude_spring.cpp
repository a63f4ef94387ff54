#include "force/altitude_spring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "force/altitude_blend.h"
#include "force/colouring.h"
#include "force/kinds.h"

namespace drape {

std::optional<Altitude> altitude_of(const Vec3& x1, const Vec3& x2, const Vec3& x3) {
    const Vec3 edge = x2 - x1, arm = x3 - x1;
    const double squared = edge.squaredNorm();
    if (squared == 0) return std::nullopt;
    const double foot = arm.dot(edge) / squared;
    const Vec3 rise = arm - foot * edge;
    const double height = rise.norm();
    // a height of round-off size points anywhere, along the edge too
    constexpr double round_off = 4 * std::numeric_limits<double>::epsilon();
    if (height <= round_off * arm.norm()) return std::nullopt;
    return Altitude{foot, height, rise / height};
}

AltitudeSprings::AltitudeSprings(const Cloth& cloth, FootSharing sharing)
    : faces_(cloth.mesh.faces.array() + cloth.first),
      rest_(cloth.network.altitudes),
      damping_(Points::Zero(3, cloth.mesh.triangles())),
      mode_(cloth.fabric.altitude),
      slack_(mode_ == AltitudeMode::compressed ? cloth.fabric.compressed_beyond : 0),
      sharing_(sharing),
      damped_(cloth.fabric.damping > 0) {
    if (!damped_) return;
    for (int t = 0; t < cloth.mesh.triangles(); ++t) {
        for (int k = 0; k < 3; ++k) {
            // b = 2 zeta sqrt(k m_red), m_red = 1 / (1/m3 + (1-a)^2/m1 + a^2/m2)
            const int i1 = cloth.mesh.faces((k + 1) % 3, t), i2 = cloth.mesh.faces((k + 2) % 3, t);
            const int i3 = cloth.mesh.faces(k, t);
            const auto altitude =
                altitude_of(cloth.mesh.rest.col(i1), cloth.mesh.rest.col(i2), cloth.mesh.rest.col(i3));
            if (!altitude) continue;
            const TriangleAltitudes& rest = rest_[static_cast<size_t>(t)];
            const double weight = mode_ == AltitudeMode::all ? rest.weight[k] : rest.common_weight;
            const double stiffness = weight / (rest.rest_height[k] * rest.rest_height[k]);
            const double a = altitude->foot;
            const double inverse_mass =
                1 / cloth.mass[i3] + (1 - a) * (1 - a) / cloth.mass[i1] + a * a / cloth.mass[i2];
            damping_(k, t) = 2 * cloth.fabric.damping * std::sqrt(stiffness / inverse_mass);
        }
    }
}

AltitudeSprings::Pull AltitudeSprings::pull_of(In x, Eigen::Index triangle, int corner, double weight,
                                               double slack) const {
    Pull pull{faces_((corner + 1) % 3, triangle),
              faces_((corner + 2) % 3, triangle),
              faces_(corner, triangle),
              {0, 0, Vec3::Zero()},
              0,
              0,
              0,
              0};
    const double rest = rest_[static_cast<size_t>(triangle)].rest_height[corner];
    if (const auto altitude = altitude_of(x.col(pull.x1), x.col(pull.x2), x.col(pull.x3)))
        pull.altitude = *altitude;
    const double strain = pull.altitude.height / rest - 1;
    if (slack > 0 && strain >= -slack) return pull;
    pull.tension = weight / rest * (strain + slack);
    pull.stiffness = weight / (rest * rest);
    pull.damping = damping_(corner, triangle);
    pull.energy = 0.5 * weight * (strain + slack) * (strain + slack);
    return pull;
}

// h0/h of each corner, but for a common factor: edge lengths over their rest lengths
Eigen::Vector3d AltitudeSprings::compression_of(In x, Eigen::Index triangle) const {
    const Vec3 a = x.col(faces_(0, triangle)), b = x.col(faces_(1, triangle)), c = x.col(faces_(2, triangle));
    const Eigen::Vector3d length((c - b).norm(), (a - c).norm(), (b - a).norm());
    return length.cwiseProduct(rest_[static_cast<size_t>(triangle)].rest_height);
}

template <class Visit>
void AltitudeSprings::each_of(Eigen::Index t, In x, Visit visit) const {
    const TriangleAltitudes& rest = rest_[static_cast<size_t>(t)];
    if (mode_ == AltitudeMode::all) {
        for (int k = 0; k < 3; ++k) visit(pull_of(x, t, k, rest.weight[k], 0));
        return;
    }
    int corner = 0;
    compression_of(x, t).maxCoeff(&corner);  // ties go to the first corner
    visit(pull_of(x, t, corner, rest.common_weight, slack_));
}

template <class Visit>
void AltitudeSprings::each(In x, Visit visit) const {
    for (Eigen::Index t = 0; t < faces_.cols(); ++t) each_of(t, x, visit);
}

double AltitudeSprings::energy(In x) const {
    double energy = 0;
    each(x, [&](const Pull& pull) { energy += pull.energy; });
    return energy;
}

void AltitudeSprings::add_conservative(In x, Out f) const {
    each(x, [&](const Pull& p) {
        const double a = sharing_ == FootSharing::lever ? p.altitude.foot : 1 - p.altitude.foot;
        const Vec3 force = p.tension * p.altitude.up;  // on the foot
        f.col(p.x1) += (1 - a) * force;
        f.col(p.x2) += a * force;
        f.col(p.x3) -= force;
    });
}

Power AltitudeSprings::add_all(In x, In v, double, Out f) const {
    add_conservative(x, f);
    if (!damped_) return {};
    double dissipated = 0;
    each(x, [&](const Pull& p) {
        if (p.stiffness == 0) return;
        const double a = p.altitude.foot;
        const double rate = p.altitude.up.dot(v.col(p.x3) - (1 - a) * v.col(p.x1) - a * v.col(p.x2));
        const Vec3 force = p.damping * rate * p.altitude.up;
        f.col(p.x1) += (1 - a) * force;
        f.col(p.x2) += a * force;
        f.col(p.x3) -= force;
        dissipated += p.damping * rate * rate;
    });
    return {dissipated, 0};
}

// As springs are (edge_projection.h), with C = h - h0, grad C = (-(1-a), -a, 1) n.
void AltitudeSprings::project(WeightedPoints& x, const WeightedPoints& before, double h) {
    if (order_.empty())
        order_ = colour_elements({faces_.data(), static_cast<size_t>(faces_.size())}, 3).order;
    const auto here = x.topRows<3>();
    const auto change = [&](int vertex) -> Vec3 {
        return x.col(vertex).head<3>() - before.col(vertex).head<3>();
    };
    for (const int triangle : order_) {
        each_of(triangle, here, [&](const Pull& p) {
            if (p.stiffness == 0) return;
            const double a = p.altitude.foot, damping = p.damping / h;
            const double way = p.altitude.up.dot(change(p.x3) - (1 - a) * change(p.x1) - a * change(p.x2));
            const double w1 = (1 - a) * x(3, p.x1), w2 = a * x(3, p.x2), w3 = x(3, p.x3);
            const double inverse_mass = (1 - a) * w1 + a * w2 + w3;
            const double pull =
                (p.tension + damping * way) / (1 / (h * h) + inverse_mass * (p.stiffness + damping));
            x.col(p.x1).head<3>() += pull * w1 * p.altitude.up;
            x.col(p.x2).head<3>() += pull * w2 * p.altitude.up;
            x.col(p.x3).head<3>() -= pull * w3 * p.altitude.up;
        });
    }
}

// With T = dE/dh, w = (-(1-a), -a, 1), q = (-1, 1, 0), t along the edge and b across the triangle's plane,
// the Hessian is, block by block,
//   (k/h0 w w' - T h/L^2 q q') nn' - T/L (q w' nt' + w q' tn') + T/h w w' bb'
// A positive semidefinite bound of each block's norm, summed along its row, bounds the spring; the parts that
// are negative (bb' when compressed, qq' when stretched) buckle and do not vibrate. An edge that has shrunk
// to less than h0 / 10 counts as that long, or a triangle collapsing to a point would ask for steps of zero.
Eigen::Vector3d AltitudeSprings::row_sums(In x, const Pull& p) {
    const double a = p.altitude.foot, tension = std::abs(p.tension);
    const double slack_height = p.altitude.height - p.tension / p.stiffness;
    const double length = std::max((x.col(p.x2) - x.col(p.x1)).norm(), 0.1 * slack_height);
    const double w[] = {std::abs(1 - a), std::abs(a), 1}, q[] = {1, 1, 0};
    const double turning = p.tension < 0 ? tension * p.altitude.height / (length * length) : 0;
    const double hanging = p.tension > 0 ? tension / p.altitude.height : 0;
    Eigen::Vector3d rows = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const double in_plane = p.stiffness * w[i] * w[j] + turning * q[i] * q[j] +
                                    tension / length * std::max(q[i] * w[j], w[i] * q[j]);
            rows[i] += std::max(in_plane, hanging * w[i] * w[j]);
        }
    }
    return rows;
}

void AltitudeSprings::add_bound(In x, StepBound& bound) const {
    const bool all = mode_ == AltitudeMode::all;
    for (Eigen::Index t = 0; t < faces_.cols(); ++t) {
        const TriangleAltitudes& rest = rest_[static_cast<size_t>(t)];
        const Eigen::Vector3d compression = compression_of(x, t);
        Eigen::Vector3d stiffness = Eigen::Vector3d::Zero(), damping = stiffness;  // by corner
        for (int k = 0; k < 3; ++k) {
            // where one altitude is chosen, those that a small change would choose count too: at rest, all
            // three
            if (!all && compression[k] < 0.95 * compression.maxCoeff()) continue;
            const Pull p = pull_of(x, t, k, all ? rest.weight[k] : rest.common_weight, slack_);
            if (p.stiffness == 0) continue;
            const double a = p.altitude.foot;
            const Eigen::Vector3d rows = row_sums(x, p), w(std::abs(1 - a), std::abs(a), 1);
            for (int i = 0; i < 3; ++i) {
                const int corner = (k + 1 + i) % 3;  // x1, x2, x3
                const double damping_row = p.damping * w[i] * w.sum();
                stiffness[corner] = all ? stiffness[corner] + rows[i] : std::max(stiffness[corner], rows[i]);
                damping[corner] =
                    all ? damping[corner] + damping_row : std::max(damping[corner], damping_row);
            }
        }
        for (int k = 0; k < 3; ++k) {
            bound.stiffness[faces_(k, t)] += stiffness[k];
            bound.damping[faces_(k, t)] += damping[k];
        }
    }
}

void AltitudeSprings::add_couplings(Couplings& couplings) const {
    for (Eigen::Index t = 0; t < faces_.cols(); ++t)
        couplings.couple(std::array{faces_(0, t), faces_(1, t), faces_(2, t)});
}

// h^2 is the least over a of |x3 - (1 - a) x1 - a x2|^2, so its half has the Hessian w w' (x) I, less the
// Schur complement of a: L^2 grad a (grad a)'. That half's Hessian is also grad h (grad h)' + h hess h, so
// with grad h = w (x) n
//   hess h = 1/h w w' (x) (I - n n') - L^2/h grad a (grad a)',   grad a = w (x) t / L + h / L^2 q (x) n
// and the spring's is dT/dh grad h (grad h)' + T hess h. Of several altitudes that could act it is that of
// the chosen one.
void AltitudeSprings::add_stiffness(In x, BlockMatrix& k) const {
    each(x, [&](const Pull& p) {
        const double a = p.altitude.foot, height = p.altitude.height;
        if (p.stiffness == 0 || height == 0) return;
        const Vec3 edge = x.col(p.x2) - x.col(p.x1), &n = p.altitude.up;
        const double squared = edge.squaredNorm(), w[] = {a - 1, -a, 1}, q[] = {-1, 1, 0};
        const Mat3 block =
            p.stiffness * n * n.transpose() + p.tension / height * (Mat3::Identity() - n * n.transpose());
        BlockMatrix::Element element(9, 9);
        Eigen::Matrix<double, 9, 1> foot_gradient;
        for (int i = 0; i < 3; ++i) {
            foot_gradient.segment<3>(3 * i) = (w[i] * edge + q[i] * height * n) / squared;
            for (int j = 0; j < 3; ++j) element.block<3, 3>(3 * i, 3 * j) = w[i] * w[j] * block;
        }
        element -= p.tension * squared / height * foot_gradient * foot_gradient.transpose();
        k.add_element(std::array{p.x1, p.x2, p.x3}, element);
    });
}

void AltitudeSprings::add_damping(In x, In, double, BlockMatrix& b) const {
    if (!damped_) return;
    each(x, [&](const Pull& p) {
        if (p.stiffness == 0) return;
        const double a = p.altitude.foot;
        b.add_point(std::array{p.x1, p.x2, p.x3}, std::array{a - 1, -a, 1.0},
                    p.damping * p.altitude.up * p.altitude.up.transpose());
    });
}

// Of add_stiffness's parts only two are ever positive. In tension it is the first, at most k (w.u)^2 for a
// move u; in compression the edge's turning joins in, which as long as h >= 2/3 h0 and the edge is not
// shorter than at rest adds no more than k/2 (h0 / L0)^2 |u1 - u2|^2. With the foot on its edge (w.u)^2 is at
// most |u3 - u1|^2 + |u3 - u2|^2, by Jensen's inequality; with the foot a part e of the edge beyond the end
// x1, by Cauchy's, (1 + e) |u3 - u1|^2 + e (1 + e) |u1 - u2|^2. Holds in that range, for feet not farther out
// than at rest by more than a quarter of the edge.
template <class Add>
void AltitudeSprings::bound_triangle(Eigen::Index t, const Eigen::Vector3d& coefficient, Add add) const {
    const TriangleAltitudes& rest = rest_[static_cast<size_t>(t)];
    // edges are as the reciprocals of altitudes, L_i = D / h_i, and Heron's formula on those gives D
    const Eigen::Vector3d reciprocal = rest.rest_height.cwiseInverse();
    const double half = reciprocal.sum() / 2;
    const double doubled_area =
        0.5 / std::sqrt(half * (half - reciprocal[0]) * (half - reciprocal[1]) * (half - reciprocal[2]));
    const Eigen::Vector3d squared = (doubled_area * reciprocal).cwiseAbs2();
    Eigen::Vector3d pairs = Eigen::Vector3d::Zero();  // of the edge opposite each corner
    for (int k = 0; k < 3; ++k) {
        const int x1 = (k + 1) % 3, x2 = (k + 2) % 3;
        const double foot = (squared[x2] + squared[k] - squared[x1]) / (2 * squared[k]);
        const double before = 0.25 + std::max(-foot, 0.0), after = 0.25 + std::max(foot - 1, 0.0);
        const double out = std::max(before, after);
        Eigen::Vector3d one;
        one[x2] = 1 + before;
        one[x1] = 1 + after;
        one[k] = out * (1 + out) + rest.rest_height[k] * rest.rest_height[k] / (2 * squared[k]);
        one *= coefficient[k];
        // of several that could act one does
        pairs = mode_ == AltitudeMode::all ? Eigen::Vector3d(pairs + one) : pairs.cwiseMax(one);
    }
    for (int k = 0; k < 3; ++k) add(faces_((k + 1) % 3, t), faces_((k + 2) % 3, t), pairs[k]);
}

void AltitudeSprings::add_stiffness_majorant(Majorant& k) const {
    for (Eigen::Index t = 0; t < faces_.cols(); ++t) {
        const TriangleAltitudes& rest = rest_[static_cast<size_t>(t)];
        const Eigen::Vector3d weight =
            mode_ == AltitudeMode::all ? rest.weight : Eigen::Vector3d::Constant(rest.common_weight);
        bound_triangle(t, weight.cwiseQuotient(rest.rest_height.cwiseAbs2()),
                       [&](int i, int j, double c) { k.add_difference(i, j, c); });
    }
}

void AltitudeSprings::add_damping_majorant(Majorant& b) const {
    if (!damped_) return;
    for (Eigen::Index t = 0; t < faces_.cols(); ++t)
        bound_triangle(t, damping_.col(t), [&](int i, int j, double c) { b.add_difference(i, j, c); });
}

int AltitudeSprings::feet_outside(In x) const {
    int outside = 0;
    each(x,
         [&](const Pull& p) { outside += p.stiffness > 0 && (p.altitude.foot < 0 || p.altitude.foot > 1); });
    return outside;
}

MadeForce make_altitude_springs(const Cloth& cloth, const Surroundings&) {
    if (cloth.fabric.membrane != MembraneKind::none)
        return {nullptr, "finite elements take their place (membrane)"};
    switch (cloth.fabric.altitude) {
        case AltitudeMode::none:
            return {nullptr, "fabric has altitude mode none"};
        case AltitudeMode::blend:
            return {std::make_unique<AltitudeBlend>(cloth), "altitude mode blend"};
        case AltitudeMode::all:
            return {std::make_unique<AltitudeSprings>(cloth), "altitude mode all"};
        case AltitudeMode::shortest:
            return {std::make_unique<AltitudeSprings>(cloth), "altitude mode shortest"};
        case AltitudeMode::compressed:
            return {std::make_unique<AltitudeSprings>(cloth), "altitude mode compressed"};
    }
    return {};
}

}  // namespace drape
