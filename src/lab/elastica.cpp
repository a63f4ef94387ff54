#include "lab/elastica.h"

#include <cmath>
#include <numbers>

namespace drape {

namespace {

constexpr int steps = 2000;  // of the classical Runge-Kutta method: exact to 1e-10

struct Bend {
    double angle = 0, curvature = 0;
};

Bend slope_of(const Bend& at, double s, double load) {
    return {at.curvature, -load * (1 - s) * std::cos(at.angle)};
}

Bend along(const Bend& from, const Bend& slope, double h) {
    return {from.angle + h * slope.angle, from.curvature + h * slope.curvature};
}

// The curvature that the tip is left with, and the way there.
double shoot(double first_curvature, double load, Elastica* way) {
    const double h = 1.0 / steps;
    Bend now{0, first_curvature};
    double reach = 0, drop = 0;
    if (way) way->places = {{0, 0}};
    for (int i = 0; i < steps; ++i) {
        const double s = i * h;
        const Bend k1 = slope_of(now, s, load), k2 = slope_of(along(now, k1, h / 2), s + h / 2, load);
        const Bend k3 = slope_of(along(now, k2, h / 2), s + h / 2, load);
        const Bend k4 = slope_of(along(now, k3, h), s + h, load);
        const Bend next{
            now.angle + h / 6 * (k1.angle + 2 * k2.angle + 2 * k3.angle + k4.angle),
            now.curvature + h / 6 * (k1.curvature + 2 * k2.curvature + 2 * k3.curvature + k4.curvature)};
        // Simpson's rule; the angle half way by Hermite's cubic
        const double middle = (now.angle + next.angle) / 2 + h / 8 * (now.curvature - next.curvature);
        reach += h / 6 * (std::cos(now.angle) + 4 * std::cos(middle) + std::cos(next.angle));
        drop += h / 6 * (std::sin(now.angle) + 4 * std::sin(middle) + std::sin(next.angle));
        now = next;
        if (way && (i + 1) % (steps / 50) == 0) way->places.push_back({reach, drop});
    }
    if (way) way->reach = reach, way->drop = drop;
    return now.curvature;
}

}  // namespace

// The tip's curvature grows with the first one as long as the strip never points beyond straight down.
Elastica heavy_cantilever(double load) {
    double low = 0, high = load / 2 + 1;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (shoot(middle, load, nullptr) < 0 ? low : high) = middle;
    }
    Elastica found;
    shoot((low + high) / 2, load, &found);
    return found;
}

}  // namespace drape
