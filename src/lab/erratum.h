// A free triangle on edge and altitude springs, with the altitudes' forces shared among the edge's ends as
// the lever has it, or as the lecture notes print it.
#pragma once

#include <string>
#include <vector>

#include "force/altitude_spring.h"

namespace drape {

// The base is 10 cm from x1 to x2; the apex stands at these shares of it along and above.
struct TriangleShape {
    std::string name;
    double along = 0, above = 0;
};
std::vector<TriangleShape> erratum_shapes();  // the first is the one in the figure

struct FreeTriangle {
    std::vector<double> time;      // [s]
    std::vector<double> energy;    // kinetic and elastic, over that at the start [-]
    std::vector<double> momentum;  // angular, about the centre of mass [kg m^2/s]
    double momentum_scale = 0;     // sqrt(2 E I): all its energy at the start turned into spin [kg m^2/s]
};

// Stretched by a tenth and let go at rest. Ends early where energy has grown a thousandfold.
FreeTriangle free_triangle(const TriangleShape& shape, FootSharing sharing, double duration);

// What the altitude springs' forces do along a closed path of shapes, there and round, over the elastic
// energy on the way: 0 for the gradient of an energy.
double work_round_loop(const TriangleShape& shape, FootSharing sharing);

}  // namespace drape
