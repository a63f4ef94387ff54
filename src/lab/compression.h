// One triangle, its apex pushed towards its base and through it.
#pragma once

#include <string>
#include <vector>

#include "lab/elastic.h"

namespace drape {

// Edges alone, with each mode of altitude springs, and both membranes; all as stiff at rest.
std::vector<Law> compression_laws();

struct Resistance {
    double ratio = 0;  // height of the apex over its height at rest; negative: beyond the base
    double force = 0;  // on the apex towards its place at rest, over stretch stiffness times base [-]
};

// What a law answers to an equilateral triangle whose base is held and whose apex is at `ratio`.
double resistance_at(const Fabric& fabric, double ratio);

struct CompressionCurve {
    std::string law;
    std::vector<Resistance> samples;  // from 1.2 down to -0.2
    Resistance peak;                  // where compression meets most
    double at_collapse = 0;           // just above the base
    double inverted = 0;              // at -0.1; below 0 it pushes further
    double barrier = 0;  // work from rest to collapse, over stretch stiffness times base squared [-]
};

CompressionCurve compression_curve(const Law& law);

}  // namespace drape
