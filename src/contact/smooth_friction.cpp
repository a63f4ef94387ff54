#include "contact/smooth_friction.h"

#include <cmath>

#include "contact/self_contact.h"

namespace drape {

namespace {

constexpr double creep = SmoothFriction::creep;

double potential_of(double speed) {  // S
    const double y = speed / creep;
    return creep * (y < 1 ? y * y - y * y * y / 3 : y - 1.0 / 3);
}
double over_speed(double speed) {  // s / |u|
    const double y = speed / creep;
    return y < 1 ? (2 - y) / creep : 1 / speed;
}
double slope(double speed) {  // ds / d|u|
    return speed < creep ? 2 * (1 - speed / creep) / creep : 0;
}

}  // namespace

void SmoothFriction::hold(const Contact& contact) {
    grips_.clear();
    for (const ObstacleContact& pair : contact.pairs()) pair.list_grips(grips_);
    if (contact.self()) contact.self()->list_grips(grips_);
}

Vec3 SmoothFriction::sliding(const Grip& grip, In v) const {
    Vec3 relative = -grip.surface_velocity;
    for (int k = 0; k < grip.corners; ++k) relative += grip.weight[k] * v.col(grip.vertex[k]);
    return relative - relative.dot(grip.normal) * grip.normal;
}

double SmoothFriction::potential(In v) const {
    double sum = 0;
    for (const Grip& grip : grips_) sum += grip.most * potential_of(sliding(grip, v).norm());
    return sum;
}

ContactWork SmoothFriction::add_force(In v, Out f) const {
    ContactWork power;
    for (const Grip& grip : grips_) {
        const Vec3 u = sliding(grip, v);
        const Vec3 force = -grip.most * over_speed(u.norm()) * u;
        for (int k = 0; k < grip.corners; ++k) f.col(grip.vertex[k]) += grip.weight[k] * force;
        power.dissipated -= force.dot(u);
        power.driven += force.dot(grip.surface_velocity);
    }
    return power;
}

// With t the direction of sliding, -df/du = mu N (s / |u| (I - n n' - t t') + ds/d|u| t t').
void SmoothFriction::add_damping(In v, BlockMatrix& b) const {
    for (const Grip& grip : grips_) {
        const Vec3 u = sliding(grip, v);
        const double speed = u.norm(), ratio = over_speed(speed);
        Mat3 rate = ratio * (Mat3::Identity() - grip.normal * grip.normal.transpose());
        if (speed > 0) rate += (slope(speed) - ratio) / (speed * speed) * u * u.transpose();
        const auto corners = static_cast<size_t>(grip.corners);
        b.add_point({grip.vertex, corners}, {grip.weight, corners}, grip.most * rate);
    }
}

void SmoothFriction::add_majorant(In v, double c, Eigen::VectorXd& diagonal) const {
    for (const Grip& grip : grips_) {
        const double bound = grip.most * over_speed(sliding(grip, v).norm()) / c;
        double all = 0;  // w w' is at most diag(|w|) times this
        for (int k = 0; k < grip.corners; ++k) all += std::abs(grip.weight[k]);
        for (int k = 0; k < grip.corners; ++k)
            diagonal[grip.vertex[k]] += all * std::abs(grip.weight[k]) * bound;
    }
}

}  // namespace drape
