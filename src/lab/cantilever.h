// A strip of cloth clamped at one end, bent by its own weight.
#pragma once

#include <string_view>

#include "cloth/fabric.h"
#include "lab/elastica.h"
#include "mesh/mesh.h"

namespace drape {

inline constexpr double standard_gravity = 9.80665;  // [m/s^2]

struct StripSize {
    double length = 0.2, width = 0.025;  // of the free part [m]
    int divisions = 20;                  // edges along it
    std::uint64_t seed = 1;
};

// Along x, clamped at x = 0, which is the middle of a row of triangles that are held: the edge at their far
// side bends with what hangs there, half as much as it would inside. `alternating`, `one_way`: a grid;
// `equilateral`; `pseudo_random`; `adaptive`: the same, twice as fine at the clamp, where it bends most, as
// at the tip.
Mesh clamped_strip(std::string_view mesh, const StripSize& size);

struct HangingTip {
    double reach = 0, drop = 0;                 // of the free end's middle [m]
    std::vector<std::array<double, 2>> places;  // (along, down) of the vertices near the middle line [m]
    bool at_rest = false;
    double slope() const { return drop / reach; }
};

HangingTip bend_strip(const Mesh& strip, const Fabric& fabric, double gravity);

// Peirce's bending length as ASTM D1388 measures it: half the overhang whose tip lies 41.5 degrees below the
// clamp. The strip hangs under more or less gravity until it does, which is the same as more or less
// overhang: l^3 w counts alone.
struct BendingLength {
    double length = 0;    // c [m]
    double rigidity = 0;  // B = w c^3 [N m]
};
BendingLength measure_bending_length(const Fabric& fabric);

}  // namespace drape
