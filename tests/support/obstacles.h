// Obstacles for tests: a few of every kind, sharp and round, turned every way.
#pragma once

#include <random>

#include "base/names.h"
#include "obstacle/obstacle.h"

namespace drape::test {

std::shared_ptr<const Solid> solid_of(std::string_view kind, const ShapeParameters& shape);

Obstacle obstacle_of(std::string_view kind, const ShapeParameters& shape, double friction = 0,
                     RigidMotion motion = {});

struct TestSolid {
    std::string name;
    ShapeParameters shape;
    std::shared_ptr<const Solid> solid;
    bool bounded() const { return std::isfinite(solid->reach()); }
};

Vec3 random_direction(std::mt19937& random);

ShapeParameters random_shape(std::mt19937& random);

// For each kind in the table three of random size and place: sharp, slightly rounded and, where the kind
// reads it, as round as it can be.
std::vector<TestSolid> every_solid(unsigned seed = 1);

// Points in a cube that holds a bounded solid with room to spare; near a plane's centre for a plane.
std::vector<Vec3> points_around(const TestSolid& s, int count, std::mt19937& random);

// Where the distance and the normal say that the surface is.
Vec3 on_surface(const Solid& solid, const Vec3& p);

}  // namespace drape::test
