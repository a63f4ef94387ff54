// The triangle whose deflection w is quadratic, given by its values at the corners and its slopes across the
// edges at their middles (Morley's triangle).
#pragma once

#include <array>

#include "base/points.h"

namespace drape {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

// K [N/m] of the energy 1/2 d' K d of Kirchhoff's plate, d = (w_0, w_1, w_2, s_0, s_1, s_2) with s_c [1] the
// slope out of the triangle across the edge opposite corner c. The slope of a free edge takes the value of
// least energy, by which no moment acts across it: its row and column of K are zero.
//
// H, the constant second derivatives, follow from the divergence theorem. Along an edge of length l, outward
// normal n and direction t, the gradient of a quadratic w has the mean s n + (w_end - w_begin) / l t, so
//   A H = sum over edges of l s n n' + (w_end - w_begin) sym(t n')
// and the energy is 1/2 B A ( (tr H)^2 - 2 (1 - nu) det H ).
Matrix6 plate_stiffness(const std::array<Vec3, 3>& corner, double rigidity, double poisson,
                        const std::array<bool, 3>& free);

}  // namespace drape
