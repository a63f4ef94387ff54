// Poisson-disk points: random, yet none nearer to another than a spacing that may vary from place to place.
// Bridson (2007): new points are thrown into the ring around those there are until none fits.
#pragma once

#include <cstdint>
#include <functional>

#include <Eigen/Core>

namespace drape {

using SizeField = std::function<double(const Eigen::Vector2d&)>;  // the wanted edge length at a place [m]
using Region = std::function<bool(const Eigen::Vector2d&)>;       // whether a place is inside

// Border and inner points, a column each, border points first. Between two points there are at least 0.775 of
// the mean edge length wanted at the two, which fills an area A with A / length^2 points. The same seed, the
// same points, on any machine: nothing but arithmetic and square roots.
Eigen::Matrix2Xd poisson_disk(const Eigen::Matrix2Xd& border, const Region& inside,
                              const SizeField& edge_length, std::uint64_t seed);

}  // namespace drape
