// The altitude blend as a constraint: each triangle in turn is given the implicit Euler step of h that it
// would make if it were alone, as springs are (edge_projection.h). With g_k = grad_k s, u = sum g_k . (x -
// before)_k and S = sum w_k |g_k|^2,
//   h^2 f = (W (s - 1) + c u / h) / (1 / h^2 + S (W + c / h)),   x_k -= w_k h^2 f g_k.
#pragma once

#include <vector>

#include "force/altitude_blend_kernel.h"
#include "force/force.h"

namespace drape {

class BlendProjection {
public:
    BlendProjection(const blend::Columns& columns, int triangles);

    // One sweep over all triangles, colour by colour.
    void sweep(WeightedPoints& x, const WeightedPoints& before, double h) const;

private:
    std::vector<int> start_;  // of each colour, and the end
    std::vector<int> corner_[3];
    std::vector<double> inverse_squared_edge_[3], inverse_double_area_, weight_, damping_;
};

}  // namespace drape
