// A sheet on an inclined plane: whether it holds, and how it slides.
#pragma once

#include <optional>
#include <string_view>

namespace drape {

struct Slide {
    double angle = 0;         // of the plane [rad]
    double way = 0;           // along the plane, the farthest of any vertex in two seconds [m]
    double speed = 0;         // down the plane, after these [m/s]
    double acceleration = 0;  // of the second one [m/s^2]
};

inline constexpr double sliding_gravity = 9.81;  // [m/s^2]

// `slope` is the tangent of the plane's angle. Throws Error where the method gives up.
Slide slide_down(double slope, double friction, std::string_view method = "verlet",
                 std::optional<double> step = {});

// What Coulomb's law has beyond the friction angle [m/s^2].
double sliding_acceleration(double slope, double friction);

}  // namespace drape
