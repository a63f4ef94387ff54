// index.html: the stability map for its reader, in one file that needs nothing else.
#pragma once

#include <string>
#include <vector>

#include "study/provenance.h"
#include "study/stability_map.h"

namespace drape {

// The maps' SVG, in the order of figures_of(); or why there are none.
struct StabilityPlots {
    std::vector<std::string> svg;
    std::string trouble;
};

std::string stability_page(const StabilityMap& map, const StabilityPlots& plots,
                           const Provenance& provenance);

}  // namespace drape
