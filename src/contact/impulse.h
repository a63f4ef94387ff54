// What a contact changes velocities by after a kick: friction, and normal damping where that is no force.
//
// With w how easily an impulse moves the two sides apart [1/kg] and b h the damping in the time, the implicit
// step of normal damping alone changes the opening speed o to o / (1 + b h w): an impulse of -b h o / (1 + b
// h w), less only where contact would pull. Friction is at most mu times all that pressed, and what stops the
// sliding. Neither turns its speed round, so both only take energy, whatever h.
#pragma once

#include <algorithm>

#include "base/points.h"

namespace drape {

struct Pressing {
    Vec3 normal;      // away from the other side
    double pressed;   // what pushed in the time [N s]
    double damping;   // b h [kg]
    double friction;  // [-]
};

// On the side that `normal` points to [N s]; `relative` is its velocity as the other sees it [m/s].
inline Vec3 contact_impulse(const Pressing& pressing, const Vec3& relative, double inverse_mass) {
    const double opening = relative.dot(pressing.normal);
    const double damped = -pressing.damping * opening / (1 + pressing.damping * inverse_mass);
    const double normal = std::max(damped, -pressing.pressed);
    const Vec3 sliding = relative - opening * pressing.normal;
    const double speed = sliding.norm();
    if (speed == 0) return normal * pressing.normal;
    const double held = std::min(pressing.friction * (pressing.pressed + normal), speed / inverse_mass);
    return normal * pressing.normal - held / speed * sliding;
}

}  // namespace drape
