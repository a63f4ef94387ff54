#include "force/altitude_spring.h"

#include <cmath>

#include "force/altitude_blend.h"
#include "force/kinds.h"

namespace drape {

std::optional<Altitude> altitude_of(const Vec3& x1, const Vec3& x2, const Vec3& x3) {
    const Vec3 edge = x2 - x1;
    const double squared = edge.squaredNorm();
    if (squared == 0) return std::nullopt;
    const double foot = (x3 - x1).dot(edge) / squared;
    const Vec3 rise = x3 - (x1 + foot * edge);
    const double height = rise.norm();
    if (height == 0) return std::nullopt;
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

template <class Visit>
void AltitudeSprings::each(In x, Visit visit) const {
    for (Eigen::Index t = 0; t < faces_.cols(); ++t) {
        const TriangleAltitudes& rest = rest_[static_cast<size_t>(t)];
        if (mode_ == AltitudeMode::all) {
            for (int k = 0; k < 3; ++k) visit(pull_of(x, t, k, rest.weight[k], 0));
            continue;
        }
        // the least h/h0 is the largest edge length over its rest length; ties go to the first corner
        const Vec3 a = x.col(faces_(0, t)), b = x.col(faces_(1, t)), c = x.col(faces_(2, t));
        const Eigen::Vector3d length((c - b).norm(), (a - c).norm(), (b - a).norm());
        int corner = 0;
        length.cwiseProduct(rest.rest_height).maxCoeff(&corner);
        visit(pull_of(x, t, corner, rest.common_weight, slack_));
    }
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

// The spring's block is d2E/dh2 w w' n n' plus a geometric part of norm |tension| |w|^2 / h at most, with
// w = (-(1-a), -a, 1): row i sums to (stiffness + |tension| / h) |w_i| sum_j |w_j|. A flat triangle would
// make the geometric part unbounded; its pull is transverse and slack there, so h is taken no smaller than h0
// / 10.
void AltitudeSprings::add_bound(In x, StepBound& bound) const {
    each(x, [&](const Pull& p) {
        if (p.stiffness == 0) return;
        const double a = p.altitude.foot;
        const Eigen::Vector3d w(std::abs(1 - a), std::abs(a), 1);
        const double least = std::max(p.altitude.height, 0.1 * std::abs(p.tension) / p.stiffness);
        const double stiffness = p.stiffness + std::max(0.0, p.tension) / least;
        const int vertex[] = {p.x1, p.x2, p.x3};
        for (int i = 0; i < 3; ++i) {
            bound.stiffness[vertex[i]] += stiffness * w[i] * w.sum();
            bound.damping[vertex[i]] += p.damping * w[i] * w.sum();
        }
    });
}

int AltitudeSprings::feet_outside(In x) const {
    int outside = 0;
    each(x, [&](const Pull& p) { outside += p.altitude.foot < 0 || p.altitude.foot > 1; });
    return outside;
}

MadeForce make_altitude_springs(const Cloth& cloth, const Surroundings&) {
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
