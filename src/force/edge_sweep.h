// Edge springs as an explicit step sweeps them: four at a time, in an order in which a spring seldom waits
// for the one before (spread_elements), all that four need in one piece of memory.
#pragma once

#include <cstdint>
#include <vector>

#include "base/padded.h"
#include "cloth/network.h"

namespace drape {

class EdgeSweep {
public:
    EdgeSweep(const std::vector<Spring>& springs, int first_vertex);

    // f += the pull of all springs; the second with damping, returns the power turned to heat [W]
    void pull(const PaddedPoints& x, PaddedPoints& f) const;
    double pull_damped(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const;

    struct Four {
        std::uint32_t a[4] = {}, b[4] = {};  // where their ends begin among all coordinates
        double rest_length[4] = {}, stiffness[4] = {}, damping[4] = {};
    };

private:
    std::vector<Four> fours_;  // the last is filled up with springs that do not pull
};

}  // namespace drape
