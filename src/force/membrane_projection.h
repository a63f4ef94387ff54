// A membrane as constraints: each triangle in turn is given the implicit Euler step of h that it would make
// if it were alone, as springs are (edge_projection.h), in parts one after the other. With w_v the inverse
// masses, y = h^2 dE/dC for the part's measures C, and N = sum_v w_v grad_v C . grad_v C,
//   x_v -= w_v sum y grad_v C,   where
//   St. Venant-Kirchhoff   C = Q_k - Q_k0 of the three edges:  (2 T^-1 / h^2 + N) y = C
//   neo-Hookean, shape     C = (a . e1 - b . e2, a . e2 + b . e1), with a, b the columns of F and e1, e2 axes
//   in
//                          the triangle's plane, so that |C| = s1 - s2; N = sum w_v |g_v|^2 times identity:
//                          y = C / (1 / (h^2 mu A) + N)
//   neo-Hookean, area      C = J - 1:  y = C / (1 / (h^2 kappa A) + N)
//   damping                y = h^2 t / 2 of the viscous tensions t, with u = grad Q . (x - before):
//                          (2 T^-1 / (h tau) + N) y = u
#pragma once

#include <vector>

#include "force/force.h"
#include "force/membrane_element.h"

namespace drape {

class MembraneProjection {
public:
    MembraneProjection(const std::vector<MembraneElement>& elements, MembraneKind kind,
                       const MembraneModuli& moduli);

    // One sweep over all triangles, colour by colour.
    void sweep(WeightedPoints& x, const WeightedPoints& before, double h) const;

private:
    struct Triangle {
        MembraneElement element;
        Mat3 compliance;  // 2 T^-1 [m^3/N]
    };
    void relax_edges(const Triangle& triangle, double h, WeightedPoints& x) const;
    void relax_shape(const MembraneElement& element, double h, WeightedPoints& x) const;
    void relax_area(const MembraneElement& element, double h, WeightedPoints& x) const;
    void damp(const Triangle& triangle, const WeightedPoints& before, double h, WeightedPoints& x) const;

    MembraneKind kind_;
    MembraneModuli moduli_;
    std::vector<Triangle> triangles_;  // colour after colour
};

}  // namespace drape
