// Problems with an analytic answer: what drape makes of them, and whether that is near enough.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "lab/cantilever.h"

namespace drape {

struct Check {
    std::string problem, on;  // on which mesh, with which forces
    double reference = 0, measured = 0;
    double tolerance = 0;  // relative; in the unit of both where the reference is 0
    std::string fineness;  // of the mesh
    double off() const { return reference == 0 ? measured : measured / reference - 1; }
    bool passes() const { return std::abs(off()) <= tolerance; }
};

// A strip that hardly stretches, of Poisson's ratio 0, under the load G of the elastica.
HangingTip loaded_tip(std::string_view mesh, BendingKind kind, double load, int divisions);
inline constexpr double loaded_length = 0.2;  // its free length [m]

std::vector<Check> check_curtain(int rows);                                // its three slowest swings
Check check_strip(const std::string& on, const Fabric& fabric, int rows);  // by its own weight
std::vector<Check> check_slope();  // holds below the friction angle, slides above

}  // namespace drape
