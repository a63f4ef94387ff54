// Altitude blend: one smooth spring a triangle in place of the shortest altitude's, without its force jumps.
// With D twice the area, L_i the edges, h_i0 the rest altitudes, p = 8, hm the mean of h_i0:
//   M = (1/3 sum (L_i h_i0)^p)^(1/p),   s = D / M,   E = 1/2 K hm (s - 1)^2
// Since L_i0 h_i0 = D0 at rest, that is s = (D / D0) / mean_8(L_i / L_i0): stretch of the area over the
// 8-mean of the edges' stretch; min_i h_i / h_i0 for p to infinity. With q_i = (L_i / L_i0)^2 and S = 1/3 sum
// q_i^4:
//   s = (D / D0) S^(-1/8),   grad s = grad D / (D0 S^(1/8)) - s / (3 S) sum q_i^3 / L_i0^2 (x_j - x_k)
// Damping f = -c (grad s)(grad s . v). A triangle without area has no direction and no force.
#pragma once

#include "force/blend_sweep.h"
#include "force/padded_force.h"

namespace drape {

class BlendProjection;

class AltitudeBlend final : public PaddedForce {
public:
    explicit AltitudeBlend(const Cloth& cloth);
    ~AltitudeBlend() override;

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
    // calls visit(triangle, corners, shape and its derivatives) for every triangle with area
    template <class Visit>
    void each_shape(In x, Visit visit) const;

    // calls add(i, j, c) for each edge's c |x_i - x_j|^2 / 2 in the majorant of `coefficient` grad s grad s'
    template <class Add>
    void bound_triangle(size_t triangle, double coefficient, Add add) const;

    std::vector<int> corner_[3];                   // columns of the State
    std::vector<double> inverse_squared_edge_[3];  // 1 / L_i0^2 of the edge opposite corner i [1/m^2]
    std::vector<double> inverse_double_area_;      // 1 / D0 [1/m^2]
    std::vector<double> weight_;                   // W = K hm [J]
    std::vector<double> damping_;                  // c [J s]
    BlendSweep sweep_;
    bool damped_ = false;
    std::unique_ptr<BlendProjection> projection_;  // made on first use
};

}  // namespace drape
