// The contact potential: energy per area of cloth at a gap g from an obstacle, inside a thickness d, with u =
// g/d and strength P [Pa]:
//   psi = P d ( 1/u + 2 ln u - u ),  pressure p = -psi' = P (1 - u)^2 / u^2,
//   stiffness psi'' = 2 P / d (1 - u) / u^3            for 0 < u < 1, all zero for u >= 1
// It is twice continuously differentiable at u = 1 and rises without bound towards the surface, so nothing at
// finite energy gets through; near u = 1 it is soft, so cloth at rest on an obstacle does not set the step.
// It rises as 1/u: a logarithm would too, but so slowly that all of double precision's gaps hold no more than
// some tens of P d, and the corner of a flag that the wind whips at another brings more.
#pragma once

#include <cmath>
#include <limits>

namespace drape {

struct Barrier {
    double thickness = 0;  // d [m]
    double strength = 0;   // P [Pa]

    double energy(double gap) const {  // per area [J/m^2]
        if (gap >= thickness) return 0;
        if (gap <= 0) return std::numeric_limits<double>::infinity();
        const double u = gap / thickness;
        return strength * thickness * (1 / u + 2 * std::log(u) - u);
    }
    double pressure(double gap) const {  // [Pa]; needs 0 < gap
        if (gap >= thickness) return 0;
        const double u = gap / thickness, part = (1 - u) / u;
        return strength * part * part;
    }
    double stiffness(double gap) const {  // per area [N/m per m^2]; needs 0 < gap
        if (gap >= thickness) return 0;
        const double u = gap / thickness;
        return 2 * strength / thickness * (1 - u) / (u * u * u);
    }
    double stiffness_slope(double gap) const {  // psi''' per area [N/m^2 per m^2]; needs 0 < gap
        if (gap >= thickness) return 0;
        const double u = gap / thickness;
        return -2 * strength / (thickness * thickness) * (3 - 2 * u) / (u * u * u * u);
    }
    // where it presses with `pressure` [m]
    double gap_under(double pressure) const { return thickness / (1 + std::sqrt(pressure / strength)); }
};

}  // namespace drape
