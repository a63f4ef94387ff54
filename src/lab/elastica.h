// The heavy cantilever in the plane: theta'' = -G (1 - s) cos theta, theta(0) = 0, theta'(1) = 0, where s
// runs along the strip from 0 to 1 and theta is how far it points down. G = w L^3 / B with the weight per
// area w [N/m^2], the free length L [m] and the bending rigidity B [N m].
#pragma once

#include <array>
#include <vector>

namespace drape {

struct Elastica {
    double reach = 0, drop = 0;                 // of the tip, over L
    std::vector<std::array<double, 2>> places;  // (along, down) of points at equal distances, over L
    double slope() const { return drop / reach; }
};

Elastica heavy_cantilever(double load);

}  // namespace drape
