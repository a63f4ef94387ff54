// A strip that is coarse on one side and fine on the other, pulled along: how much stronger the fine side is.
#pragma once

#include <vector>

#include "lab/elastic.h"

namespace drape {

// A strip twice as long as it is wide in the plane y = 0: `rows` squares across its left half, twice as many
// across the right, cut by turns one way and the other; where they meet, coarse squares have a vertex more.
Mesh graded_strip(int rows);

// The stiffness models, edges alone, and finite elements.
std::vector<Law> density_laws();

struct StripPull {
    std::string law;
    std::vector<double> place, strain;  // along the strip [m], over its mean [-]
    double coarse = 0, fine = 0;        // mean strain in the middle of each half, over that of the strip [-]
    double ratio() const { return coarse / fine; }  // how much stronger the fine half is
};

// One end is held, the other pulled away; the sides are free.
StripPull pull_strip(const Law& law, int rows);

// What theory has for that ratio: springs half as long of one force per strain are twice as strong per width,
// those of one constant or of one modulus as strong.
double predicted_ratio(const Law& law);

}  // namespace drape
