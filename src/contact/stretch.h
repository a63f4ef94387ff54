// How hard cloth resists stretch, as the step bound sees it.
#pragma once

#include "cloth/model.h"

namespace drape {

// stiffness per area [N/m per m^2]
inline double stretch_stiffness_per_area(const Cloth& cloth) {
    double sum = 0;
    for (const Spring& edge : cloth.network.edges) sum += 4 * edge.stiffness;
    return sum / cloth.area.sum();
}

}  // namespace drape
