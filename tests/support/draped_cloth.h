// A cloth that hangs over a sphere in folds, written down instead of simulated: something to draw.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/pattern.h"

namespace drape {

inline constexpr double draped_sphere_radius = 0.3;  // [m]
inline const Vec3 draped_sphere_centre(0, 0.3, 0);

// A sheet of 1 m x 1 m laid over the sphere: distances from its middle run down the sphere, then straight
// down.
inline Points draped_over_sphere(const Mesh& sheet) {
    const double r = draped_sphere_radius,
                 leaves = 1.35;  // angle from the top where the cloth leaves the sphere
    Points x = sheet.rest;
    for (int v = 0; v < x.cols(); ++v) {
        const double u = sheet.rest(0, v), w = sheet.rest(2, v);
        const double from_middle = std::hypot(u, w), around = std::atan2(w, u);
        const double angle = std::min(from_middle / r, leaves),
                     hangs = std::max(from_middle - leaves * r, 0.0);
        const double depth = std::clamp((angle - 0.7) / (leaves - 0.7), 0.0, 1.0);
        // folds stand off the ball, never in it
        const double fold =
            1 + 0.7 * std::cos(10 * around + 1.3 * std::sin(2 * around)) + 0.3 * std::cos(19 * around + 1);
        const double out = (r + 0.004) * std::sin(angle) + fold * (0.02 * depth * depth + 0.2 * hangs);
        const double down = (r + 0.004) * std::cos(angle) - 0.96 * hangs;
        x.col(v) = draped_sphere_centre + Vec3(out * std::cos(around), down, out * std::sin(around));
    }
    return x;
}

// A ball of `rings` x 2 `rings` quads.
inline Mesh ball(double radius, int rings) {
    const int columns = 2 * rings;
    Points x(3, 2 + (rings - 1) * columns);
    x.col(0) = Vec3(0, radius, 0);
    x.col(x.cols() - 1) = Vec3(0, -radius, 0);
    const auto at = [&](int ring, int column) { return 1 + (ring - 1) * columns + column % columns; };
    for (int ring = 1; ring < rings; ++ring)
        for (int column = 0; column < columns; ++column) {
            const double down = std::numbers::pi * ring / rings, around = std::numbers::pi * column / rings;
            x.col(at(ring, column)) = radius * Vec3(std::sin(down) * std::cos(around), std::cos(down),
                                                    -std::sin(down) * std::sin(around));
        }
    std::vector<Eigen::Vector3i> faces;
    const int last = static_cast<int>(x.cols()) - 1;
    for (int column = 0; column < columns; ++column) {
        faces.emplace_back(0, at(1, column), at(1, column + 1));
        faces.emplace_back(last, at(rings - 1, column + 1), at(rings - 1, column));
        for (int ring = 1; ring + 1 < rings; ++ring) {
            faces.emplace_back(at(ring, column), at(ring + 1, column), at(ring + 1, column + 1));
            faces.emplace_back(at(ring, column), at(ring + 1, column + 1), at(ring, column + 1));
        }
    }
    Faces columns_of(3, static_cast<Eigen::Index>(faces.size()));
    for (size_t f = 0; f < faces.size(); ++f) columns_of.col(static_cast<Eigen::Index>(f)) = faces[f];
    return plain_mesh(x, columns_of);
}

}  // namespace drape
