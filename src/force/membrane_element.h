// A constant-strain triangle as finite elements have it: its rest shape, and what its energy is made of.
//
// In the rest triangle's plane let g_k [1/m] be the slope of the function that is 1 at corner k and 0 at the
// others, r_k = X_(k+2) - X_(k+1) the edge opposite corner k, A the area, and Q_k the squared length of that
// edge now, Q_k0 at rest. g_(k+1) . r_k = -1, g_(k+2) . r_k = 1, g_k . r_k = 0, so that
//   M_k = -1/2 (g_(k+1) g_(k+2)' + g_(k+2) g_(k+1)')   has   r_j' M_k r_j = 1 for j = k, else 0
// and the metric C = F'F, F the 3 x 2 gradient of the deformation, is C = sum Q_k M_k. An isotropic energy of
// C is one of Q_k, and its forces act along the edges, as springs' do: with t_k = 2 dE/dQ_k [N/m] and e_k the
// edge now, grad_k E = t_(k+1) e_(k+1) - t_(k+2) e_(k+2). No torque, no net force, whatever t_k.
//
// Plane stress of Young's modulus times thickness Y [N/m] and Poisson's ratio nu:
//   mu = Y / (2 (1 + nu)),   lambda = Y nu / (1 - nu^2),   kappa = lambda + mu = Y / (2 (1 - nu))
// Its energy, quadratic in Green's strain (C - I) / 2 = 1/2 sum (Q_k - Q_k0) M_k, is
//   A (mu E:E + lambda/2 (tr E)^2) = 1/4 sum T_kj dQ_k dQ_j,   T_kj = A (mu M_k:M_j + lambda/2 tr M_k tr M_j)
#pragma once

#include <array>

#include "cloth/model.h"

namespace drape {

// Plane stress [N/m].
struct MembraneModuli {
    double mu = 0, lambda = 0, kappa = 0;
};
MembraneModuli moduli_of(const Fabric& fabric);

using Vec2 = Eigen::Vector2d;

struct MembraneElement {
    std::array<int, 3> corner{};                                          // columns of the State
    double area = 0;                                                      // A [m^2]
    std::array<Vec2, 3> slope{Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};  // g_k [1/m]
    Eigen::Vector3d squared = Eigen::Vector3d::Zero();                    // Q_k0 [m^2]
    Eigen::Vector3d trace = Eigen::Vector3d::Zero();                      // tr M_k [1/m^2]
    Mat3 coupling = Mat3::Zero();                                         // T [N/m^3]
    double relaxation = 0;  // tau: viscous stress is T tau dQ/dt [s]
};

// The cloth's triangle f. Damping is that ratio of critical for the fastest motion of the triangle alone.
MembraneElement membrane_element(const Cloth& cloth, int f);

// The gradients' products sum_v w_v grad_v Q_k . grad_v Q_j of a triangle with these edges e_k.
Mat3 edge_products(const std::array<Vec3, 3>& edge, const Eigen::Vector3d& weight);

// What a triangle is like at a pose.
struct MembranePose {
    std::array<Vec3, 3> edge;  // e_k, from corner k + 1 to corner k + 2 [m]
    Eigen::Vector3d squared;   // Q_k [m^2]
    double doubled_area;       // [m^2]
};
MembranePose membrane_pose(const MembraneElement& element, In x);

// The energy and its derivatives by Q.
struct MembraneResponse {
    double energy;            // [J]
    Eigen::Vector3d tension;  // t_k = 2 dE/dQ_k [N/m]
    Mat3 change;              // dt_k / dQ_j [N/m^3]
};
// St. Venant-Kirchhoff: the energy above.
MembraneResponse stvk_response(const MembraneElement& element, const MembranePose& pose);

// Stable neo-Hookean. With J = D / D0 the stretch of the area and s1, s2 the principal stretches,
//   E = A (mu/2 (tr C - 2 J) + kappa/2 (J - 1)^2) = A (mu/2 (s1 - s2)^2 + kappa/2 (s1 s2 - 1)^2)
// the first part for shape, the second for area: finite in a triangle without area, where it still pushes,
// and quadratic near rest with the moduli above. D^2 = |e_1 x e_2|^2 has dD^2/dQ_k = b_k =
// (Q_(k+1) + Q_(k+2) - Q_k) / 2, so with p = kappa (J - 1) - mu
//   t_k = mu A tr M_k + p b_k / (2 D)
//   dt_k/dQ_j = kappa b_k b_j / (4 D^2 D0) + p ((1/2 - (k = j)) / (2 D) - b_k b_j / (4 D^3))
// A triangle without area has no normal to push along: there p counts as 0.
MembraneResponse neo_hookean_response(const MembraneElement& element, const MembranePose& pose,
                                      const MembraneModuli& moduli);

}  // namespace drape
