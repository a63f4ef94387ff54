// Plate bending: per triangle of rest area A, with constant second derivatives x_uu, x_uv, x_vv of the
// positions,
//   E = 1/2 B A ( |x_uu + x_vv|^2 - 2 (1 - nu) (x_uu . x_vv - |x_uv|^2) )
// Kirchhoff's plate energy with bending rigidity B [N m] and Poisson's ratio nu, for isometric deformations,
// where x_uu is curvature times the normal. It is linear in x: the force is -K x with a constant, positive
// semidefinite K, assembled once. Damping -tau K v, tau [s].
//
// The triangles are Morley's (plate_element.h). Their second unknown, the slope across each edge, is not one
// here: it is told by the vertices round the edge, exactly for quadratic surfaces (edge_slope.h), and both
// triangles at the edge use the same. What vertices can do is so a part of what Morley's plate can: it is no
// softer than that plate on any mesh, bends as it does when refined, and its rigidity does not depend on the
// mesh as that of hinges does. (Curvatures fitted triangle by triangle are as exact for quadratic surfaces,
// but a free surface steps to the sides of the smooth one by turns and stores 0.7 of the energy on
// alternating diagonals.) Border edges are free: no moment acts across them.
#pragma once

#include <vector>

#include "force/padded_force.h"

namespace drape {

// Of each row of a symmetric matrix the diagonal and what follows it, vertices numbered within the cloth.
struct UpperRows {
    std::vector<int> start, column;
    std::vector<double> value;
};

class BendPlate final : public PaddedForce {
public:
    explicit BendPlate(const Cloth& cloth);

    double energy(In x) const override;
    void add_padded_conservative(const PaddedPoints& x, PaddedPoints& f) const override;
    Power add_padded(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const override;
    bool is_conservative() const override { return tau_ == 0; }
    void add_bound(In x, StepBound& bound) const override;
    void add_couplings(Couplings& couplings) const override;
    void add_stiffness(In x, BlockMatrix& k) const override;
    void add_damping(In x, In v, double time, BlockMatrix& b) const override;
    void add_stiffness_majorant(Majorant& k) const override;
    void add_damping_majorant(Majorant& b) const override;

private:
    // visit(i, j, K_ij) for all i <= j, columns of the State
    template <class Visit>
    void each_entry(Visit visit) const;

    int first_ = 0;
    UpperRows k_;     // [N/m]
    double tau_ = 0;  // [s]
};

// The relaxation time that gives bending waves of wave number 1 / l_b the fabric's damping ratio, where
// l_b = (B / (rho g))^(1/3) is the fabric's bending length: tau = 2 zeta / omega, omega = sqrt(B / rho) /
// l_b^2. It belongs to the fabric, not to the mesh; but never so long that damping would shorten the step
// that the stretch springs ask for: tau <= 0.1 omega_stretch / omega_bend^2 of this mesh.
double bending_relaxation_time(const Cloth& cloth, double fastest_bend_squared);

}  // namespace drape
