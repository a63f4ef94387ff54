// Three altitude springs in every triangle: how many of them stand outside their edge, what that does to
// their force, and how the ways to choose among them drape and what they cost.
#pragma once

#include <string>
#include <string_view>

#include "cloth/fabric.h"
#include "mesh/mesh.h"

namespace drape {

// The feet of a mesh's altitudes at rest.
struct Feet {
    double outside = 0;     // share that do not stand on their edge [-]
    double most_lever = 1;  // the largest share of an altitude's force that an end of its edge takes [-]
};
Feet feet_of(const Mesh& mesh);

struct ModeDrape {
    double coefficient = 0;  // of Cusick's test [-]
    double omega = 0;  // of the fastest mode of the disc at rest: steps are as many as that asks for [1/s]
};
ModeDrape drape_with(AltitudeMode mode, double edge);

}  // namespace drape
