#include "contact/layers.h"

#include <algorithm>
#include <cmath>

#include "contact/stretch.h"

namespace drape {

namespace {

constexpr double falling_part = 0.25;  // of the speed of a free fall

// How fast one part of a cloth may meet another: by what it starts with, carried by pins, and by falling
// from its own height [m/s]. What falls falls together, and parts meet with less: of a sheet draped
// over a ball a quarter takes least steps, half or a tenth take more.
double meeting_speed(const Model& model, const Vec3& gravity, const State& start) {
    Eigen::AlignedBox3d speeds, room;
    double pins = 0;
    for (const Cloth& cloth : model.cloths) {
        if (!cloth.self_contact) continue;
        for (int i = cloth.first; i < cloth.first + cloth.vertices(); ++i) {
            speeds.extend(Vec3(start.v.col(i)));
            room.extend(Vec3(start.x.col(i)));
        }
    }
    if (room.isEmpty()) return 0;
    for (const PinGroup& group : model.pins)
        pins = std::max(pins, group.motion.top_speed(group.rigid ? room.diagonal().norm() : 0));
    const double fallen = std::sqrt(2 * gravity.norm() * room.diagonal().norm());
    return speeds.diagonal().norm() + falling_part * fallen + pins;
}

double density_of(const Cloth& cloth) {
    return cloth.mass.sum() / cloth.area.sum();
}

// As ObstacleContact has it: the impact stopped about half way in, and what does not set the step. A layer of
// cloth presses the one below it to 0.9 of the thickness.
double strength_of(const Layers& layers, double weight, double speed, double stretch) {
    const double impact = layers.density * speed * speed / 2 / layers.barrier.thickness;
    return std::max({80 * weight, 2 * impact, stretch * layers.barrier.thickness / 60});
}

Layers between(const Cloth& one, const Cloth& two, double gravity, double speed) {
    Layers both;
    both.barrier.thickness = (one.fabric.thickness + two.fabric.thickness) / 2;
    both.density = density_of(one) * density_of(two) / (density_of(one) + density_of(two));
    both.friction = (one.fabric.friction + two.fabric.friction) / 2;
    both.barrier.strength =
        strength_of(both, std::max(density_of(one), density_of(two)) * gravity, speed,
                    std::min(stretch_stiffness_per_area(one), stretch_stiffness_per_area(two)));
    return both;
}

Layers between(const Cloth& cloth, const Obstacle& mesh, double gravity, double speed) {
    Layers both;
    both.barrier.thickness = cloth.fabric.thickness / 2 + mesh.thickness;
    both.density = density_of(cloth);
    both.friction = mesh.friction;
    both.barrier.strength =
        strength_of(both, density_of(cloth) * gravity, speed, stretch_stiffness_per_area(cloth));
    return both;
}

}  // namespace

std::vector<Layers> layers_between(const Surfaces& surfaces, const Model& model, const Vec3& gravity,
                                   const State& start, double duration) {
    const double speed = meeting_speed(model, gravity, start);
    const int count = surfaces.count();
    Layers none{};
    none.barrier.thickness = -1;
    std::vector<Layers> layers(static_cast<size_t>(count * count), none);
    for (int a = 0; a < static_cast<int>(model.cloths.size()); ++a) {
        const Cloth& cloth = model.cloths[static_cast<size_t>(a)];
        for (int b = a; b < count; ++b) {
            if (!surfaces.meet(a, b)) continue;
            Layers& both = layers[static_cast<size_t>(layers_of(a, b, count))];
            if (const Obstacle* mesh = surfaces.mesh(b))
                both = between(cloth, *mesh, gravity.norm(),
                               impact_speed(cloth, *mesh, gravity, start, duration));
            else
                both = between(cloth, model.cloths[static_cast<size_t>(b)], gravity.norm(), speed);
        }
    }
    return layers;
}

double impact_speed(const Cloth& cloth, const Obstacle& obstacle, const Vec3& gravity, const State& start,
                    double duration) {
    const auto x = start.x.middleCols(cloth.first, cloth.vertices());
    const auto v = start.v.middleCols(cloth.first, cloth.vertices());
    const Pose pose = obstacle.motion.at(0).pose;
    double way = 0;
    for (Eigen::Index i = 0; i < x.cols(); ++i)
        way = std::max(way, obstacle.solid->sample(pose.back(x.col(i))).distance);
    const double g = gravity.norm(), fall = std::min(way, g * duration * duration / 2);
    const double started = std::sqrt(v.colwise().squaredNorm().maxCoeff());
    return started + std::sqrt(2 * g * fall) + obstacle.surface_speed();
}

}  // namespace drape
