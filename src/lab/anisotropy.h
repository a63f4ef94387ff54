// Stiffness by direction, for every mesh pattern and several ways to resist stretch.
#pragma once

#include <string>
#include <vector>

#include "lab/elasticity.h"

namespace drape {

struct Stuff {
    std::string name;
    Fabric fabric;
};

// Edge springs as the lecture notes have them, as drape spreads them, with altitude springs; finite elements.
std::vector<Stuff> stuffs();

struct PatternStiffness {
    std::string pattern, stuff;
    DirectionCurve stretch, shear;
};

// One square sheet of about divisions^2 quads.
PatternStiffness pattern_stiffness(std::string_view pattern, const Stuff& stuff, int divisions,
                                   std::uint64_t seed);

}  // namespace drape
