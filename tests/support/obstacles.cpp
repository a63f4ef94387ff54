#include "support/obstacles.h"

namespace drape::test {

std::shared_ptr<const Solid> solid_of(std::string_view kind, const ShapeParameters& shape) {
    return find_named(solid_kinds(), "obstacle", kind).make(shape);
}

Obstacle obstacle_of(std::string_view kind, const ShapeParameters& shape, double friction,
                     RigidMotion motion) {
    return {std::string(kind), solid_of(kind, shape), std::move(motion), friction};
}

Vec3 random_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Vec3::NullaryExpr([&] { return normal(random); }).normalized();
}

ShapeParameters random_shape(std::mt19937& random) {
    const auto within = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    ShapeParameters shape;
    shape.centre = 0.3 * random_direction(random);
    shape.normal = within(0.5, 2) * random_direction(random);
    shape.axis = within(0.5, 2) * random_direction(random);
    shape.from = 0.2 * random_direction(random);
    shape.to = shape.from + within(0.1, 0.6) * random_direction(random);
    shape.size = Vec3(within(0.2, 0.8), within(0.2, 0.8), within(0.2, 0.8));
    shape.rotate_deg = 180 * random_direction(random);
    shape.radius = within(0.2, 0.5);
    shape.tube_radius = shape.radius * within(0.1, 0.7);
    shape.height = within(0.2, 0.8);
    return shape;
}

std::vector<TestSolid> every_solid(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<TestSolid> solids;
    for (const SolidKind& kind : solid_kinds()) {
        for (const double roundness : {0.0, 0.1, 1.0}) {
            ShapeParameters shape = random_shape(random);
            shape.rounding =
                roundness * std::min({shape.size.minCoeff() / 2, shape.radius, shape.height / 2});
            solids.push_back({cat(kind.name, ", roundness ", roundness), shape, solid_of(kind.name, shape)});
        }
    }
    return solids;
}

std::vector<Vec3> points_around(const TestSolid& s, int count, std::mt19937& random) {
    const double size = s.bounded() ? 1.5 * s.solid->reach() : 1;
    std::uniform_real_distribution<double> value(-size, size);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i)
        points.push_back(s.solid->centre() + Vec3(value(random), value(random), value(random)));
    return points;
}

Vec3 on_surface(const Solid& solid, const Vec3& p) {
    const SurfaceSample s = solid.sample(p);
    return p - s.distance * s.normal;
}

}  // namespace drape::test
