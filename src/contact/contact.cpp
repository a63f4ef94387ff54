#include "contact/contact.h"

#include <algorithm>
#include <cmath>

#include "contact/layers.h"
#include "contact/self_contact.h"

namespace drape {

namespace {

// No column is longer; the longest may be shorter by up to sqrt 3, but this needs no column's own length.
template <class Columns>
double most_length(const Columns& columns) {
    return std::sqrt(3.0) * columns.cwiseAbs().maxCoeff();
}

}  // namespace

Contact::Contact(const Model& model, const std::vector<Obstacle>& obstacles, const Vec3& gravity,
                 const State& start, double duration)
    : model_(model), self_(SelfContact::make(model, obstacles, gravity, start, duration)) {
    for (const Cloth& cloth : model.cloths) {
        for (const Obstacle& obstacle : obstacles) {
            if (obstacle.solid->triangles()) continue;  // self_'s
            pairs_.emplace_back(model, cloth, obstacle, gravity,
                                impact_speed(cloth, obstacle, gravity, start, duration));
            thickness_ = std::max(thickness_, pairs_.back().barrier().thickness);
            obstacle_speed_ = std::max(obstacle_speed_, obstacle.surface_speed());
        }
    }
}

Contact::~Contact() = default;

void Contact::prepare(const State& state, double h) {
    if (self_) self_->prepare(h);
    if (pairs_.empty()) return;
    // twice what this step needs
    cover(state.x, state.time, 2 * h * (most_length(state.v) + obstacle_speed_));
}

void Contact::cover(In x, double time, double way) {
    if (pairs_.empty()) return;
    if (way_ >= 0) {
        const double moved =
            most_length(x - gathered_at_) + obstacle_speed_ * std::abs(time - gathered_time_);
        if (moved + way <= way_) return;
    }
    way_ = std::max(4 * thickness_, 20 * way);
    gathered_at_ = x;
    gathered_time_ = time;
    for (ObstacleContact& pair : pairs_) pair.gather(x, time, way_);
}

double Contact::clear_part(In x, In move, double time) const {
    double clear = 1;
    for (const ObstacleContact& pair : pairs_) clear = std::min(clear, pair.clear_part(x, move, time));
    return self_ ? std::min(clear, self_->clear_part(x, move, time)) : clear;
}

bool Contact::passed_through(const State& before, const State& after) {
    if (self_ && self_->passed_through(before, after)) return true;
    if (obstacle_speed_ == 0) return false;
    const double moved = std::sqrt((after.x - before.x).colwise().squaredNorm().maxCoeff());
    cover(before.x, before.time, moved + obstacle_speed_ * (after.time - before.time));
    return std::any_of(pairs_.begin(), pairs_.end(), [&](const ObstacleContact& pair) {
        return pair.passed_through(before.x, before.time, after.x, after.time);
    });
}

double Contact::energy(In x, double time) const {
    double energy = self_ ? self_->energy(x, time) : 0;
    for (const ObstacleContact& pair : pairs_) energy += pair.energy(x, time);
    return energy;
}

void Contact::add_conservative(In x, double time, Out f) const {
    for (const ObstacleContact& pair : pairs_) pair.add_conservative(x, time, f);
    if (self_) self_->add_conservative(x, time, f);
}

ObstacleContact::Result Contact::add_all(In x, In v, double time, Out f, NormalDamping damping) {
    ObstacleContact::Result all;
    const auto include = [&](const ObstacleContact::Result& result) {
        all.dissipated += result.dissipated;
        all.driven += result.driven;
        all.limits.include(result.limits);
        all.least_distance = std::min(all.least_distance, result.least_distance);
        all.contacts += result.contacts;
        all.crossed = all.crossed || result.crossed;
    };
    for (ObstacleContact& pair : pairs_) include(pair.add_all(x, v, time, f, damping));
    if (self_) include(self_->add_all(x, v, time, f, damping));
    return all;
}

void Contact::add_couplings(Couplings& couplings) const {
    for (const ObstacleContact& pair : pairs_) pair.add_couplings(couplings);
    if (self_) self_->add_couplings(couplings);
}

long Contact::couplings_version(In x, double time) const {
    return self_ ? self_->couplings_version(x, time) : 0;
}

void Contact::add_stiffness(In x, In v, double time, BlockMatrix& k) const {
    for (const ObstacleContact& pair : pairs_) pair.add_stiffness(x, v, time, k);
    if (self_) self_->add_stiffness(x, v, time, k);
}

void Contact::add_damping(In x, In v, double time, BlockMatrix& b) const {
    for (const ObstacleContact& pair : pairs_) pair.add_damping(x, v, time, b);
    if (self_) self_->add_damping(x, v, time, b);
}

void Contact::add_majorant(In x, In v, double time, double c, Eigen::VectorXd& diagonal) const {
    for (const ObstacleContact& pair : pairs_) pair.add_majorant(x, v, time, c, diagonal);
}

ContactWork Contact::rub(Points& v, double h) const {
    ContactWork all;
    const auto include = [&](const ContactWork& work) {
        all.dissipated += work.dissipated;
        all.driven += work.driven;
    };
    for (const ObstacleContact& pair : pairs_) include(pair.rub(v, model_, h));
    if (self_) include(self_->rub(v, h));
    return all;
}

double Contact::least_distance(In x, double time, bool held) const {
    double least = self_ ? self_->least_distance(x, time, held) : INFINITY;
    for (const ObstacleContact& pair : pairs_) least = std::min(least, pair.least_distance(x, time, held));
    return least;
}

int Contact::crossings(In x, double time) const {
    return self_ ? self_->crossings(x, time).pairs : 0;
}

double Contact::lift_out(Points& x) const {
    double largest = 0;
    for (const ObstacleContact& pair : pairs_)
        largest = std::max(largest, pair.lift_out(x, model_, 2 * pair.barrier().thickness));
    // out of one may be into another, and pins do not move
    for (const ObstacleContact& pair : pairs_) pair.demand_outside(x);
    if (self_) self_->demand_apart(x);
    return largest;
}

}  // namespace drape
