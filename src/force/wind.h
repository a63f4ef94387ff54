// Air: linear drag, and wind as drag and lift on every triangle. (Equations and class in wind.cpp.)
#pragma once

#include <cstdint>

#include "base/points.h"

namespace drape {

struct AirDescription {
    double drag = 0;           // linear drag per area [kg/(s m^2)]; 0 = none
    bool aerodynamic = false;  // `wind` was given, be it zero (still air): quadratic drag and lift
    Vec3 wind = Vec3::Zero();  // [m/s]
    double density = 1.2;      // of air [kg/m^3]
    double lift = 0.5;         // lift coefficient over drag coefficient [-]
    double gust_strength = 0;  // peak deviation of the wind over its mean [-]
    double gust_period = 1.5;  // [s]
    std::uint64_t seed = 1;
};

}  // namespace drape
