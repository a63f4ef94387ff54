// The altitude blend as an explicit step sweeps it: four triangles at a time, as springs are (edge_sweep.h).
// s depends on the squared edges Q_k alone. With e_k the edge opposite corner k, q_k = Q_k / L_k0^2, and
// dD^2/dQ_k = -e_(k+1) . e_(k+2) = (Q_(k+1) + Q_(k+2) - Q_k) / 2,
//   t_k = 2 ds/dQ_k = (Q_(k+1) + Q_(k+2) - Q_k) / (2 D D0 S^(1/8)) - s q_k^3 / (3 S L_k0^2)
//   grad_k s = t_(k+1) e_(k+1) - t_(k+2) e_(k+2)
// so that no cross product but the one that D comes from is needed; D from the Q_k would lose its digits in
// slivers.
#pragma once

#include <cstdint>
#include <vector>

#include "base/padded.h"
#include "force/altitude_blend_kernel.h"

namespace drape {

class BlendSweep {
public:
    BlendSweep() = default;
    BlendSweep(const blend::Columns& columns, int triangles);

    // f += the push of all triangles; the second with damping, returns the power turned to heat [W]
    void push(const PaddedPoints& x, PaddedPoints& f) const;
    double push_damped(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const;

    struct Four {
        std::uint32_t corner[3][4] = {};  // where their corners begin among all coordinates
        double inverse_squared_edge[3][4] = {}, inverse_double_area[4] = {}, weight[4] = {}, damping[4] = {};
    };

private:
    std::vector<Four> fours_;  // the last is filled up with triangles of no weight
};

}  // namespace drape
