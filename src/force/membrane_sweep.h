// A membrane as an explicit step sweeps it: four triangles at a time, as the blend is (blend_sweep.h), by the
// edges' tensions (membrane_element.h).
#pragma once

#include <cstdint>
#include <vector>

#include "base/padded.h"
#include "force/membrane_element.h"

namespace drape {

class MembraneSweep {
public:
    MembraneSweep(const std::vector<MembraneElement>& elements, MembraneKind kind,
                  const MembraneModuli& moduli);

    // f += the push of all triangles; the second with damping, returns the power turned to heat [W]
    void push(const PaddedPoints& x, PaddedPoints& f) const;
    double push_damped(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const;

    struct Four {
        std::uint32_t corner[3][4] = {};  // where their corners begin among all coordinates
        double squared[3][4] = {};        // Q_k0
        double diagonal[3][4] = {};       // T_kk
        double beside[3][4] = {};         // T_ij of the two edges that are not k
        double relaxation[4] = {};        // tau
        double shape[3][4] = {};          // mu A tr M_k; neo-Hookean only, as is the next
        double inverse_double_area[4] = {};
    };

private:
    std::vector<Four> fours_;  // the last is filled up with triangles without stiffness
    MembraneKind kind_;
    MembraneModuli moduli_;
};

}  // namespace drape
