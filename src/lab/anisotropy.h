// Stiffness by direction, for every mesh pattern and several ways to resist stretch.
#pragma once

#include <string>
#include <vector>

#include "lab/elastic.h"
#include "lab/elasticity.h"

namespace drape {

// Edge springs as the lecture notes have them, as drape spreads them, with altitude springs; finite elements.
std::vector<Law> stretch_laws();

struct PatternStiffness {
    std::string pattern, law;
    DirectionCurve stretch, shear;
};

// One square sheet of about divisions^2 quads.
PatternStiffness pattern_stiffness(std::string_view pattern, const Law& law, int divisions,
                                   std::uint64_t seed);

}  // namespace drape
