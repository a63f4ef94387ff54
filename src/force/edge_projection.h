// Springs as constraints, one after the other: each is given the implicit Euler step of h that it would make
// if it were alone. With stretch C = l - l0, direction n, u = n . (x_a - x_b - before_a + before_b) and
// S = w_a + w_b, the pull f at the end of the step obeys
//   f = c (C - S h^2 f) + b (u - S h^2 f) / h,    so   h^2 f = (c C + b u / h) / (1 / h^2 + S (c + b / h)),
//   x_a -= w_a h^2 f n,   x_b += w_b h^2 f n.
// That is the projection of "XPBD: position-based simulation of compliant constrained dynamics" (Macklin,
// Mueller, Chentanez 2016) with compliance 1 / c, whose multiplier starts from 0. For l0 = 0 it is exact,
// else n is the direction before it. At l = 0 there is no direction and nothing moves.
#pragma once

#include <vector>

#include "force/force.h"

namespace drape {

class EdgeProjection {
public:
    // Columns of the State, rest lengths [m], stiffness [N/m], damping [N s/m].
    EdgeProjection(const std::vector<int>& a, const std::vector<int>& b,
                   const std::vector<double>& rest_length, const std::vector<double>& stiffness,
                   const std::vector<double>& damping);

    // One sweep over all springs, colour by colour.
    void sweep(WeightedPoints& x, const WeightedPoints& before, double h) const;

private:
    std::vector<int> start_;  // of each colour, and the end
    std::vector<int> a_, b_;
    std::vector<double> rest_length_, stiffness_, damping_;
    bool damped_ = false;
};

}  // namespace drape
