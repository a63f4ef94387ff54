#include "simulate/reach.h"

#include <algorithm>
#include <cmath>

namespace drape {

double travel_allowance(const Model& model, const State& start, const Surroundings& world, double duration) {
    const double size = (start.x.rowwise().maxCoeff() - start.x.rowwise().minCoeff()).norm();
    const double speed = std::sqrt(start.v.colwise().squaredNorm().maxCoeff()) + world.air.wind.norm() * 2;
    double pins = 0;
    for (const PinGroup& group : model.pins)
        pins = std::max(pins, group.motion.top_speed(group.rigid ? size : 0) * group.motion.end_time());
    return 2 * size + pins + speed * duration + world.gravity.norm() * duration * duration / 2;
}

double clearance(const State& start, const Obstacle& obstacle) {
    const Pose pose = obstacle.motion.at(0).pose;
    double least = INFINITY;
    for (Eigen::Index i = 0; i < start.x.cols(); ++i)
        least = std::min(least, obstacle.solid->sample(pose.back(start.x.col(i))).distance);
    if (!obstacle.motion.moves()) return least;
    if (!std::isfinite(obstacle.solid->reach())) return 0;
    return least - obstacle.surface_speed() * obstacle.motion.end_time();
}

}  // namespace drape
