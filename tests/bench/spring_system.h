// A bare mass-spring system as any engineer would hold it: arrays of numbers and a list of springs. What
// peers are given to integrate; it shares no code with drape's forces.
//   m_i x_i'' = m_i g - sum K (l - l0) n       pinned vertices have inverse mass 0 and stand still
#pragma once

#include <vector>

#include "simulate/simulation.h"

namespace drape::bench {

struct PlainSpring {
    int a = 0, b = 0;
    double rest_length = 0;  // [m]
    double stiffness = 0;    // [N/m]
};

struct SpringSystem {
    std::vector<PlainSpring> springs;
    std::vector<double> x, v;          // x0 y0 z0 x1 ... [m], [m/s]
    std::vector<double> inverse_mass;  // [1/kg]
    double gravity[3] = {0, 0, 0};     // [m/s^2]

    int vertices() const { return static_cast<int>(inverse_mass.size()); }
};

// The bare springs of the setup's one cloth; its other forces must be gravity alone.
SpringSystem spring_system(const Setup& setup);

// a = accelerations at the positions x, spring by spring in scalar double precision.
void accelerate(const SpringSystem& system, const double* x, double* a);

Points as_points(const std::vector<double>& x);

}  // namespace drape::bench
