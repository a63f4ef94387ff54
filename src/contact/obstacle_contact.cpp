#include "contact/obstacle_contact.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "contact/stretch.h"

namespace drape {

namespace {

constexpr int finest_level = 12;
constexpr double expected_stretch = 1.05;  // contact points may move apart by this

double longest_edge(const Cloth& cloth) {
    double longest = 0;
    for (const Spring& edge : cloth.network.edges) longest = std::max(longest, edge.rest_length);
    return longest;
}

double mean_edge(const Cloth& cloth) {
    double sum = 0;
    for (const Spring& edge : cloth.network.edges) sum += edge.rest_length;
    return sum / static_cast<double>(cloth.network.edges.size());
}

void push(const ContactPoint& point, const Vec3& force, double* f) {
    for (int k = 0; k < point.corners; ++k)
        Eigen::Map<Vec3>(f + 3 * point.vertex[k]) += point.weight[k] * force;
}

}  // namespace

void ContactLimits::include(const ContactLimits& other) {
    // modes of a sum are at most as fast as the fastest of each together: a vertex may touch both
    omega_squared += other.omega_squared;
    gamma += other.gamma;
    closing_rate = std::max(closing_rate, other.closing_rate);
}

ObstacleContact::ObstacleContact(const Model& model, const Cloth& cloth, const Obstacle& obstacle,
                                 const Vec3& gravity, double expected_speed)
    : obstacle_(obstacle),
      faces_(cloth.mesh.faces.array() + cloth.first),
      inverse_mass_(model.inverse_mass),
      rows_(Eigen::Matrix2Xd::Zero(2, model.vertices())),
      area_density_(cloth.mass.sum() / cloth.area.sum()) {
    barrier_.thickness = std::max(cloth.fabric.thickness, mean_edge(cloth) / 4);
    // as many points as keep the dip between them within half the thickness
    const double longest = longest_edge(cloth) * expected_stretch;
    while (level_ < finest_level && obstacle.solid->sagitta(longest / level_) > barrier_.thickness / 2)
        ++level_;
    spacing_ = longest / level_;
    offset_ = obstacle.solid->sagitta(spacing_);
    points_ = contact_points(model, cloth, level_);
    // strong enough to carry twenty times the weight and to stop the expected impact about half way in; where
    // that leaves room, a sixtieth of the stretch stiffness, which does not set the step
    const double weight = area_density_ * gravity.norm();
    const double impact = area_density_ * expected_speed * expected_speed / 2 / barrier_.thickness;
    barrier_.strength =
        std::max({20 * weight, 2 * impact, stretch_stiffness_per_area(cloth) * barrier_.thickness / 60});
    resting_gap_ = barrier_.strength > 0 ? barrier_.gap_under(weight) : barrier_.thickness;
}

SurfaceSample ObstacleContact::sample(const Pose& pose, const Vec3& p) const {
    if (!obstacle_.motion.moves()) return obstacle_.solid->sample(p);
    SurfaceSample s = obstacle_.solid->sample(pose.back(p));
    s.normal = pose.rotation * s.normal;
    return s;
}

double ObstacleContact::damping_at(double stiffness) const {
    constexpr double damping_ratio = 0.5;  // of critical, in the normal direction
    return 2 * damping_ratio * std::sqrt(area_density_ * stiffness);
}

void ObstacleContact::gather(In x, double time, double way) {
    const Pose pose = obstacle_.motion.at(time).pose;
    near_.clear();
    for (size_t i = 0; i < points_.size(); ++i)
        if (sample(pose, value_at(points_[i], x.data())).distance < offset_ + barrier_.thickness + way)
            near_.push_back(static_cast<int>(i));
}

double ObstacleContact::energy(In x, double time) const {
    const Pose pose = obstacle_.motion.at(time).pose;
    double energy = 0;
    for (const int i : near_) {
        const ContactPoint& point = points_[static_cast<size_t>(i)];
        energy += point.area * barrier_.energy(sample(pose, value_at(point, x.data())).distance - offset_);
    }
    return energy;
}

void ObstacleContact::add_conservative(In x, double time, Out f) const {
    const Pose pose = obstacle_.motion.at(time).pose;
    for (const int i : near_) {
        const ContactPoint& point = points_[static_cast<size_t>(i)];
        const SurfaceSample s = sample(pose, value_at(point, x.data()));
        const double gap = s.distance - offset_;
        if (gap >= barrier_.thickness || gap <= 0) continue;  // crossing is caught by add_all
        push(point, point.area * barrier_.pressure(gap) * s.normal, f.data());
    }
}

ObstacleContact::Result ObstacleContact::add_all(In x, In v, double time, Out f, NormalDamping damping) {
    const MovingPose moving = obstacle_.motion.at(time);
    touches_.clear();
    damping_ = damping;
    Result result;
    for (const int i : near_) {
        const ContactPoint& point = points_[static_cast<size_t>(i)];
        const Vec3 at = value_at(point, x.data());
        const SurfaceSample s = sample(moving.pose, at);
        const double gap = s.distance - offset_;
        result.least_distance = std::min(result.least_distance, s.distance);
        if (!(gap > 0)) {
            result.crossed = true;
            continue;
        }
        const Vec3 surface_velocity = obstacle_.motion.moves() ? moving.velocity_at(at) : Vec3::Zero();
        const double opening = s.normal.dot(value_at(point, v.data()) - surface_velocity);
        // a step may use up the way to the barrier and a quarter of what is left inside it
        const double room = std::max(gap - barrier_.thickness, 0.0) + std::min(gap, barrier_.thickness) / 4;
        result.limits.closing_rate = std::max(result.limits.closing_rate, -opening / room);
        if (gap >= barrier_.thickness) continue;

        const double stiffness = barrier_.stiffness(gap), pressure = barrier_.pressure(gap);
        const double rate = damping_at(stiffness);
        const double total =
            damping == NormalDamping::force ? std::max(pressure - rate * opening, 0.0) : pressure;
        push(point, point.area * total * s.normal, f.data());
        touches_.push_back({&point, s.normal, surface_velocity, point.area * total, point.area * stiffness,
                            point.area * rate});
        add_rows(touches_.back());
        result.dissipated += point.area * (pressure - total) * opening;
        result.driven += point.area * total * s.normal.dot(surface_velocity);
    }
    limit_modes(result.limits);
    result.contacts = static_cast<int>(touches_.size());
    return result;
}

void ObstacleContact::add_rows(const Touch& touch) {
    const double damping = damping_ == NormalDamping::force ? touch.damping : 0;
    for (int k = 0; k < touch.point->corners; ++k)
        rows_.col(touch.point->vertex[k]) +=
            touch.point->weight[k] * Eigen::Vector2d(touch.stiffness, damping);
}

void ObstacleContact::limit_modes(ContactLimits& limits) {
    for (const Touch& touch : touches_) {
        for (int k = 0; k < touch.point->corners; ++k) {
            const int v = touch.point->vertex[k];
            limits.omega_squared = std::max(limits.omega_squared, rows_(0, v) * inverse_mass_[v]);
            limits.gamma = std::max(limits.gamma, rows_(1, v) * inverse_mass_[v]);
            rows_.col(v).setZero();
        }
    }
}

ContactWork ObstacleContact::rub(Points& v, const Model& model, double h) const {
    ContactWork work;
    if (obstacle_.friction == 0 && damping_ == NormalDamping::force) return work;
    for (const Touch& touch : touches_) {
        const ContactPoint& point = *touch.point;
        const Vec3 relative = value_at(point, v.data()) - touch.surface_velocity;
        const double damping = damping_ == NormalDamping::impulse ? touch.damping * h : 0;
        const Vec3 impulse =
            contact_impulse({touch.normal, touch.normal_force * h, damping, obstacle_.friction}, relative,
                            point.inverse_mass);
        for (int k = 0; k < point.corners; ++k) {
            const int i = point.vertex[k];
            if (model.inverse_mass[i] == 0)  // what holds a pin works against the impulse where the pin moves
                work.driven -= point.weight[k] * impulse.dot(v.col(i));
            else
                v.col(i) += point.weight[k] * model.inverse_mass[i] * impulse;
        }
        work.dissipated -= impulse.dot(relative + point.inverse_mass / 2 * impulse);
        work.driven += impulse.dot(touch.surface_velocity);
    }
    return work;
}

void ObstacleContact::list_grips(std::vector<Grip>& grips) const {
    if (obstacle_.friction == 0) return;
    for (const Touch& touch : touches_) {
        if (!(touch.normal_force > 0)) continue;
        Grip grip{{},
                  {},
                  touch.point->corners,
                  touch.normal,
                  touch.surface_velocity,
                  obstacle_.friction * touch.normal_force};
        std::copy_n(touch.point->vertex, grip.corners, grip.vertex);
        std::copy_n(touch.point->weight, grip.corners, grip.weight);
        grips.push_back(grip);
    }
}

// The gap changes by no more than the way, so each point may go as far as its gap, look again, and go on.
double ObstacleContact::clear_part(In x, In move, double time) const {
    constexpr int most_looks = 60;
    const Pose pose = obstacle_.motion.at(time).pose;
    double clear = 1;
    for (const int i : near_) {
        const ContactPoint& point = points_[static_cast<size_t>(i)];
        const Vec3 at = value_at(point, x.data()), way = value_at(point, move.data());
        const double length = way.norm();
        const auto gap_at = [&](double part) { return sample(pose, at + part * way).distance - offset_; };
        double gap = gap_at(0), part = 0;
        if (gap <= 0) return 0;
        const double kept = 0.1 * std::min(gap, barrier_.thickness);
        for (int look = 0; look < most_looks && part * length < clear * length; ++look) {
            part += (gap - kept) / length;
            if (part >= clear) break;
            gap = gap_at(part);
            if (gap - kept < 0.01 * kept) break;
        }
        if (length > 0) clear = std::min(clear, part);
    }
    return clear;
}

// Part by part of the step: in one where point and surface move by less than the gap at its start they do not
// meet, and in one where that is next to nothing its end shows it. Vertices are taken to go straight.
bool ObstacleContact::passed_through(In before, double from, In after, double to) const {
    constexpr int most_looks = 4096;  // of a point: beyond, the step is too long to tell
    constexpr double fine = 0.25;
    const double least = fine * barrier_.thickness;
    const double shifted = obstacle_.surface_speed(from, to) * (to - from);
    if (shifted == 0) return false;
    const Points move = after - before;
    if (shifted + std::sqrt(move.colwise().squaredNorm().maxCoeff()) < least) return false;
    const Pose start = obstacle_.motion.at(from).pose;
    for (const int i : near_) {
        const ContactPoint& point = points_[static_cast<size_t>(i)];
        const Vec3 at = value_at(point, before.data()), way = value_at(point, move.data());
        const double length = way.norm();
        int looks = 0;
        const auto meet = [&](const auto& self, double begin, double end, double gap) -> bool {
            const double t0 = from + begin * (to - from), t1 = from + end * (to - from);
            const double both = obstacle_.surface_speed(t0, t1) * (t1 - t0) + length * (end - begin);
            if (gap > both || both < least) return false;
            if (++looks > most_looks) return true;
            const double middle = (begin + end) / 2;
            const Pose pose = obstacle_.motion.at((t0 + t1) / 2).pose;
            const double then = sample(pose, at + middle * way).distance;
            return then <= 0 || self(self, begin, middle, gap) || self(self, middle, end, then);
        };
        if (meet(meet, 0, 1, sample(start, at).distance)) return true;
    }
    return false;
}

double ObstacleContact::least_distance(In x, double time, bool held) const {
    const Pose pose = obstacle_.motion.at(time).pose;
    const int fine = 2 * level_ + 2;
    double least = INFINITY;
    for (Eigen::Index f = 0; f < faces_.cols(); ++f) {
        const Vec3 a = x.col(faces_(0, f)), b = x.col(faces_(1, f)), c = x.col(faces_(2, f));
        const auto is_pinned = [&](int v) { return inverse_mass_[v] == 0; };
        if (!held && (is_pinned(faces_(0, f)) || is_pinned(faces_(1, f)) || is_pinned(faces_(2, f))))
            continue;
        // the distance changes by no more than the way: far triangles need only their corner looked at
        const double reach = std::max((b - a).norm(), (c - a).norm());
        const double corner = sample(pose, a).distance;
        least = std::min(least, corner);
        if (corner - reach > least) continue;
        for (int i = 0; i <= fine; ++i)
            for (int j = 0; i + j <= fine; ++j)
                least = std::min(
                    least,
                    sample(pose, a + double(i) / fine * (b - a) + double(j) / fine * (c - a)).distance);
    }
    return least;
}

void ObstacleContact::demand_outside(In x) const {
    const Pose pose = obstacle_.motion.at(0).pose;
    double deepest = 0;
    bool inside = false;
    for (const ContactPoint& point : points_) {
        const double gap = sample(pose, value_at(point, x.data())).distance - offset_;
        inside = inside || gap <= 0;
        deepest = std::min(deepest, gap);
    }
    if (inside)
        throw Error(cat(obstacle_.place.empty() ? "" : obstacle_.place + ": ",
                        "cloth cannot start: pins or other obstacles hold it ", -deepest, " m inside the ",
                        obstacle_.kind, " (move one of them)"));
}

double ObstacleContact::lift_out(Points& x, const Model& model, double most) const {
    const Pose pose = obstacle_.motion.at(0).pose;
    const double wanted = offset_ + resting_gap_;
    const Points start = x;
    Points move(3, x.cols());
    Eigen::VectorXd length(x.cols());
    for (int round = 0; round < 50; ++round) {
        // each vertex goes as far as the deepest of its points asks, all at once: a flat sheet stays flat
        move.setZero();
        length.setZero();
        for (const ContactPoint& point : points_) {
            const SurfaceSample s = sample(pose, value_at(point, x.data()));
            if (s.distance < -most)
                throw Error(cat(obstacle_.place.empty() ? "" : obstacle_.place + ": ", "cloth starts ",
                                -s.distance, " m inside the ", obstacle_.kind, " (move one of them: at most ",
                                most, " m is put right)"));
            const double missing = wanted - s.distance;
            if (missing < 1e-6 * barrier_.thickness) continue;
            for (int k = 0; k < point.corners; ++k) {
                const int v = point.vertex[k];
                if (model.inverse_mass[v] == 0 || missing <= length[v]) continue;
                length[v] = missing;
                move.col(v) = missing * s.normal;
            }
        }
        if (length.maxCoeff() == 0) break;
        x += move;
    }
    return std::sqrt((x - start).colwise().squaredNorm().maxCoeff());
}

}  // namespace drape
