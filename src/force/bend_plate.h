// Plate bending: per triangle of rest area A, with second derivatives x_uu, x_uv, x_vv of the positions by a
// quadratic fit (plate_fit.h),
//   E = 1/2 B A ( |x_uu + x_vv|^2 - 2 (1 - nu) (x_uu . x_vv - |x_uv|^2) )
// Kirchhoff's plate energy with bending rigidity B [N m] and Poisson's ratio nu, for isometric deformations,
// where x_uu is curvature times the normal. It is linear in x: the force is -K x with a constant, positive
// semidefinite K, assembled once. Damping -tau K v, tau [s].
// The fit is exact for quadratic surfaces on every mesh, so the rigidity does not depend on the mesh as that
// of hinges does.
#pragma once

#include "force/padded_force.h"

namespace drape {

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

    int incomplete_triangles() const { return incomplete_; }

private:
    // visit(i, j, K_ij) for all i <= j, columns of the State
    template <class Visit>
    void each_entry(Visit visit) const;

    int first_ = 0;
    // K is symmetric: of each row the diagonal and what follows it, numbered within the cloth
    std::vector<int> row_, column_;
    std::vector<double> value_;  // [N/m]
    double tau_ = 0;             // [s]
    int incomplete_ = 0;
};

// The relaxation time that gives bending waves of wave number 1 / l_b the fabric's damping ratio, where
// l_b = (B / (rho g))^(1/3) is the fabric's bending length: tau = 2 zeta / omega, omega = sqrt(B / rho) /
// l_b^2. It belongs to the fabric, not to the mesh; but never so long that damping would shorten the step
// that the stretch springs ask for: tau <= 0.1 omega_stretch / omega_bend^2 of this mesh.
double bending_relaxation_time(const Cloth& cloth, double fastest_bend_squared);

}  // namespace drape
