// Edge springs: along every mesh edge, with stiffness c [N/m], rest length l0, l = |xi - xj|, n = (xi - xj) /
// l:
//   E = 1/2 c (l - l0)^2       f_i = -c (l - l0) n,   damping  f_i = -b n n' (v_i - v_j),   f_j = -f_i
// (with k = c l0 that is the notes' 1/2 k l0 (l/l0 - 1)^2). At l = 0 there is no direction and no force.
// Bend springs across an edge are the same springs on other pairs.
#pragma once

#include "force/edge_sweep.h"
#include "force/padded_force.h"

namespace drape {

class EdgeProjection;

class EdgeSprings final : public PaddedForce {
public:
    EdgeSprings(const std::vector<Spring>& springs, int first_vertex);
    ~EdgeSprings() override;

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
    std::vector<int> a_, b_;  // columns of the State
    std::vector<double> rest_length_, stiffness_, damping_;
    EdgeSweep sweep_;
    bool damped_ = false;
    std::unique_ptr<EdgeProjection> projection_;  // made on first use
};

}  // namespace drape
