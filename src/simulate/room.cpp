#include "simulate/room.h"

#include <algorithm>
#include <cmath>

namespace drape {

namespace {

constexpr int moments = 16;  // of a motion that are looked at

// Extends the room by the obstacle's whole way; returns the height of its lowest point, or of its plane.
double add_obstacle(const Obstacle& obstacle, double duration, Eigen::AlignedBox3d& room) {
    if (!std::isfinite(obstacle.solid->reach())) return obstacle.solid->centre().y();
    const Mesh surface = obstacle.solid->surface(1);
    double lowest = INFINITY;
    for (int k = 0; k <= (obstacle.motion.moves() ? moments : 0); ++k) {
        const Pose pose = obstacle.motion.at(duration * k / moments).pose;
        for (int i = 0; i < surface.vertices(); ++i) {
            const Vec3 p = pose * Vec3(surface.rest.col(i));
            room.extend(p);
            lowest = std::min(lowest, p.y());
        }
    }
    return lowest;
}

// Points straight below the pins as far as cloth reaches.
void add_hanging(const Cloth& cloth, const Model& model, In start, Eigen::AlignedBox3d& room) {
    std::vector<int> pins;
    for (int v = 0; v < cloth.vertices(); ++v)
        if (model.inverse_mass[cloth.first + v] == 0) pins.push_back(v);
    // some hundreds of pins and vertices tell as much as all
    const size_t pin_stride = 1 + pins.size() / 200;
    const int stride = 1 + cloth.vertices() / 2000;
    for (int v = 0; v < cloth.vertices(); v += stride) {
        double nearest = INFINITY;
        int pin = -1;
        for (size_t p = 0; p < pins.size(); p += pin_stride) {
            const double distance = (cloth.mesh.rest.col(v) - cloth.mesh.rest.col(pins[p])).norm();
            if (distance < nearest) {
                nearest = distance;
                pin = pins[p];
            }
        }
        if (pin >= 0) room.extend(Vec3(start.col(cloth.first + pin) - nearest * Vec3::UnitY()));
    }
}

bool is_held(const Cloth& cloth, const Model& model) {
    return (model.inverse_mass.segment(cloth.first, cloth.vertices()).array() == 0).any();
}

}  // namespace

Eigen::AlignedBox3d room_of(const Simulation& simulation) {
    const Model& model = simulation.model();
    const Points& x = simulation.state().x;
    const double duration = simulation.frames() / simulation.frame_rate();
    Eigen::AlignedBox3d room;
    double ground = INFINITY;  // the lowest end of any obstacle
    for (const Obstacle& obstacle : simulation.obstacles())
        ground = std::min(ground, add_obstacle(obstacle, duration, room));
    for (const Cloth& cloth : model.cloths) {
        Eigen::AlignedBox3d start;
        for (int v = 0; v < cloth.vertices(); ++v) start.extend(Vec3(x.col(cloth.first + v)));
        room.extend(start);
        if (is_held(cloth, model)) {
            add_hanging(cloth, model, x, room);
            continue;
        }
        const double fallen = std::isfinite(ground) ? ground : start.min().y() - start.sizes().maxCoeff() / 2;
        room.extend(Vec3(start.center().x(), std::min(start.min().y(), fallen), start.center().z()));
    }
    if (model.pins.empty()) return room;
    for (int k = 0; k <= moments; ++k) {
        State carried{x, x, duration * k / moments};
        place_pins(model, carried);
        for (const PinGroup& group : model.pins)
            for (const int v : group.vertices) room.extend(Vec3(carried.x.col(v)));
    }
    return room;
}

}  // namespace drape
