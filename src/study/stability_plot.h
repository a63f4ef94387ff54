// The maps, as a script for gnuplot: a figure per cloth with a panel per method, and one with drape's own
// choice on every cloth.
#pragma once

#include <string>
#include <vector>

#include "study/stability_map.h"

namespace drape {

struct StabilityPanel {
    std::string title;
    std::vector<const StabilityCell*> cells;
};

struct StabilityFigure {
    std::string file;   // without ending
    std::string title;  // "alternating mesh, bare springs"
    std::vector<StabilityPanel> panels;
};

std::vector<StabilityFigure> figures_of(const StabilityMap& map);

// Run in any folder it writes each figure's file as SVG and as PNG.
std::string stability_script(const StabilityMap& map);

}  // namespace drape
