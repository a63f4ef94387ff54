// A membrane of finite elements: constant-strain triangles, St. Venant-Kirchhoff or stable neo-Hookean
// (membrane_element.h), in place of springs along edges and altitudes. Its stiffness is the fabric's in every
// direction and on every mesh: near rest, linear elasticity in plane stress. Damping is viscous in Green's
// strain, tension T tau dQ/dt with every material, so that it resists no turning; the heat is
// 1/2 tau sum T_kj dQ_k/dt dQ_j/dt.
//
// St. Venant-Kirchhoff weakens as it is compressed: along one direction its resistance is greatest at
// 1/sqrt 3 of the length and gone where that is 0. Neo-Hookean resists to the end and beyond.
#pragma once

#include "force/membrane_element.h"
#include "force/membrane_sweep.h"
#include "force/padded_force.h"

namespace drape {

class MembraneProjection;

class Membrane final : public PaddedForce {
public:
    explicit Membrane(const Cloth& cloth);
    ~Membrane() override;

    double energy(In x) const override;
    void add_padded_conservative(const PaddedPoints& x, PaddedPoints& f) const override;
    Power add_padded(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const override;
    bool is_conservative() const override { return !damped_; }
    void add_bound(In x, StepBound& bound) const override;
    void add_couplings(Couplings& couplings) const override;
    void add_stiffness(In x, BlockMatrix& k) const override;
    void add_damping(In x, In v, double time, BlockMatrix& b) const override;
    void add_stiffness_majorant(Majorant& k) const override;
    void add_damping_majorant(Majorant& b) const override;
    bool projects() const override { return true; }
    void project(WeightedPoints& x, const WeightedPoints& before, double h) override;

private:
    MembraneResponse response_of(const MembraneElement& element, const MembranePose& pose) const;
    // adds `factor` A g_i . g_j at each two corners of a triangle
    static void add_scaled_laplacian(const MembraneElement& element, double factor, Majorant& majorant);

    MembraneKind kind_;
    MembraneModuli moduli_;
    bool damped_;
    std::vector<MembraneElement> elements_;
    MembraneSweep sweep_;
    std::unique_ptr<MembraneProjection> projection_;  // made on first use
};

}  // namespace drape
