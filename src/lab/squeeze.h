// A whole sheet pressed together in its plane.
#pragma once

#include <string>
#include <vector>

#include "lab/elastic.h"

namespace drape {

struct Squeeze {
    double ratio = 1;     // of its length at rest
    double force = 0;     // on an end, per width, over stretch stiffness [-]
    double inverted = 0;  // share of its triangles that are turned over [-]
    bool at_rest = true;
};

struct SqueezeCurve {
    std::string law;
    std::vector<Squeeze> samples;
    Squeeze peak;
    double first_inverted = 0;  // the largest ratio at which a triangle is turned over; 0: none
};

// A square of `divisions` quads, alternating, held in its plane, one end moved towards the other from rest to
// `last` of its length: where it rests on the way.
SqueezeCurve squeeze_curve(const Law& law, int divisions, double last);

}  // namespace drape
