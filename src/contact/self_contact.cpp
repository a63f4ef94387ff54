#include "contact/self_contact.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "contact/stretch.h"

namespace drape {

namespace {

constexpr double damping_ratio = 0.5;  // of critical, in the normal direction
constexpr double steps_a_list = 10;    // that a choice of near pairs shall last
constexpr double farthest_move = 4;    // of neighbours apart in one move of a solver, in mean edges
constexpr double kept_part = 0.1;      // of its distance, or the thickness, that a pair keeps in a move
constexpr double falling_part = 0.25;  // of the speed of a free fall
constexpr double least_start = 0.01;   // of the thickness, between layers at the start

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
    for (const PinGroup& group : model.pins)
        pins = std::max(pins, group.motion.top_speed(group.rigid ? room.diagonal().norm() : 0));
    const double fallen = std::sqrt(2 * gravity.norm() * room.diagonal().norm());
    return speeds.diagonal().norm() + falling_part * fallen + pins;
}

std::vector<std::pair<int, int>> ranges_of(const Model& model) {
    std::vector<std::pair<int, int>> ranges;
    for (const Cloth& cloth : model.cloths)
        if (cloth.self_contact) ranges.emplace_back(cloth.first, cloth.vertices());
    return ranges;
}

Faces faces_of(const Model& model) {
    Eigen::Index count = 0;
    for (const Cloth& cloth : model.cloths) count += cloth.self_contact ? cloth.mesh.triangles() : 0;
    Faces faces(3, count);
    count = 0;
    for (const Cloth& cloth : model.cloths) {
        if (!cloth.self_contact) continue;
        faces.middleCols(count, cloth.mesh.triangles()) = cloth.mesh.faces.array() + cloth.first;
        count += cloth.mesh.triangles();
    }
    return faces;
}

}  // namespace

std::unique_ptr<SelfContact> SelfContact::make(const Model& model, const Vec3& gravity, const State& start) {
    if (std::none_of(model.cloths.begin(), model.cloths.end(),
                     [](const Cloth& cloth) { return cloth.self_contact; }))
        return nullptr;
    const double speed = meeting_speed(model, gravity, start);
    const int cloths = static_cast<int>(model.cloths.size());
    std::vector<Layers> layers(static_cast<size_t>(cloths * cloths));
    std::vector<double> thickness(layers.size());
    for (int a = 0; a < cloths; ++a) {
        for (int b = a; b < cloths; ++b) {
            const Cloth &one = model.cloths[static_cast<size_t>(a)],
                        &two = model.cloths[static_cast<size_t>(b)];
            const double one_density = one.mass.sum() / one.area.sum();
            const double two_density = two.mass.sum() / two.area.sum();
            Layers& both = layers[static_cast<size_t>(layers_of(a, b, cloths))];
            both.barrier.thickness = (one.fabric.thickness + two.fabric.thickness) / 2;
            both.density = one_density * two_density / (one_density + two_density);
            both.friction = (one.fabric.friction + two.fabric.friction) / 2;
            // As against an obstacle: the impact stopped about half way in, and what does not set the step. A
            // layer of cloth presses the one below it to 0.9 of the thickness.
            const double weight = std::max(one_density, two_density) * gravity.norm();
            const double impact = both.density * speed * speed / 2 / both.barrier.thickness;
            const double stretch = std::min(stretch_stiffness_per_area(one), stretch_stiffness_per_area(two));
            both.barrier.strength =
                std::max({80 * weight, 2 * impact, stretch * both.barrier.thickness / 60});
            thickness[static_cast<size_t>(layers_of(a, b, cloths))] = both.barrier.thickness;
        }
    }
    return std::unique_ptr<SelfContact>(
        new SelfContact(model, std::move(layers), thickness, ranges_of(model)));
}

SelfContact::SelfContact(const Model& model, std::vector<Layers> layers, const std::vector<double>& thickness,
                         std::vector<std::pair<int, int>> ranges)
    : model_(model),
      faces_(faces_of(model)),
      layers_(std::move(layers)),
      search_(model, thickness),
      thickness_(*std::max_element(thickness.begin(), thickness.end())),
      found_drift_(ranges),
      near_drift_(std::move(ranges)),
      rows_(Eigen::Matrix2Xd::Zero(2, model.vertices())) {}

const Barrier& SelfContact::barrier(int cloth, int other) const {
    return layers_[static_cast<size_t>(layers_of(cloth, other, static_cast<int>(model_.cloths.size())))]
        .barrier;
}

double SelfContact::damping_of(const Layers& layers, double stiffness) const {
    return 2 * damping_ratio * std::sqrt(layers.density * stiffness);
}

void SelfContact::prepare(double h) {
    ahead_ = 2 * h;
}

void SelfContact::cover(In x, double more) {
    if (near_margin_ >= 0 && near_drift_.is_within(x, near_margin_ - more)) return;
    list(x, more);
}

// Pairs beyond the barrier by more than they can close in the time cannot shorten the step.
void SelfContact::cover(In x, In v) {
    cover(x, ahead_ * near_drift_.rate(x, v));
}

bool SelfContact::found_hold(In x) const {
    return found_margin_ >= 0 && found_drift_.is_within(x, found_margin_ - near_margin_);
}

void SelfContact::list(In x, double drift) {
    near_.clear();
    ++version_;
    if (!x.allFinite()) {  // motion that ran away: nothing holds
        near_margin_ = found_margin_ = -1;
        return;
    }
    const double least = std::max(thickness_ / 2, search_.mean_edge() / 32);
    const double most = std::max(search_.mean_edge() / 8, least);
    near_margin_ = std::max(drift, std::clamp(steps_a_list / 2 * drift, least, most));
    if (!found_hold(x)) {
        // at rest few pairs that are no neighbours are nearer
        found_margin_ = std::max(2 * near_margin_, search_.mean_edge() / 2 - thickness_);
        found_drift_.begin(x);
        search_.find(x, thickness_ + found_margin_, found_);
    }
    near_drift_.begin(x);
    for (SelfPair& pair : found_) {
        const double reach = layers(pair).barrier.thickness + near_margin_;
        if (separation(pair, x.data()) >= reach || measure(pair, points_of(pair, x.data())).distance >= reach)
            continue;
        near_.push_back(pair);
    }
}

Nearest SelfContact::measure(SelfPair& pair, const PairPoints& at) {
    const Nearest nearest = nearest_of(pair, at);
    pair.apart = nearest.normal;
    return nearest;
}

double SelfContact::energy(In x) {
    cover(x, 0);
    double energy = 0;
    for (const SelfPair& pair : near_) {
        const Barrier& barrier = layers(pair).barrier;
        if (separation(pair, x.data()) < barrier.thickness)
            energy += pair_energy(pair, barrier, points_of(pair, x.data()));
    }
    return energy;
}

void SelfContact::add_conservative(In x, Out f) {
    cover(x, 0);
    for (SelfPair& pair : near_) {
        const Barrier& barrier = layers(pair).barrier;
        if (separation(pair, x.data()) >= barrier.thickness) continue;
        const PairPoints at = points_of(pair, x.data());
        const Nearest nearest = measure(pair, at);
        if (nearest.distance >= barrier.thickness || nearest.distance == 0) continue;  // caught by add_all
        const Fade fade = fade_of(pair, at);
        const double push = pair.area * fade.part * barrier.pressure(nearest.distance);
        for (int i = 0; i < 4; ++i) f.col(pair.vertex[i]) += push * nearest.weight[i] * nearest.normal;
        if (fade.slope == 0) continue;
        const PairPoints more = fading_force(pair, at, fade, barrier.energy(nearest.distance));
        for (int i = 0; i < 4; ++i) f.col(pair.vertex[i]) += more.col(i);
    }
}

ObstacleContact::Result SelfContact::add_all(In x, In v, Out f, NormalDamping damping) {
    cover(x, v);
    touches_.clear();
    damping_ = damping;
    ObstacleContact::Result result;
    for (SelfPair& pair : near_) {
        const Layers& both = layers(pair);
        const double thickness = both.barrier.thickness;
        // as far apart as that by the time, at least: separation of a sum is no less than their sum
        const double beyond = separation(pair, x.data()) - thickness;
        if (beyond >= 0 && beyond + ahead_ * separation(pair, v.data()) >= 0) continue;
        const PairPoints at = points_of(pair, x.data());
        const Nearest nearest = measure(pair, at);
        const double gap = nearest.distance;
        if (!(gap > 0)) {
            result.crossed = true;
            continue;
        }
        Vec3 relative = Vec3::Zero();
        for (int i = 0; i < 4; ++i) relative += nearest.weight[i] * v.col(pair.vertex[i]);
        const double opening = nearest.normal.dot(relative);
        // a step may use up the way to the barrier and a quarter of what is left inside it
        const double room = std::max(gap - thickness, 0.0) + std::min(gap, thickness) / 4;
        result.limits.closing_rate = std::max(result.limits.closing_rate, -opening / room);
        if (gap >= thickness) continue;

        const Fade fade = fade_of(pair, at);
        const double share = pair.area * fade.part;
        const double stiffness = both.barrier.stiffness(gap), pressure = both.barrier.pressure(gap);
        const double rate = damping_of(both, stiffness);
        const double total =
            damping == NormalDamping::force ? std::max(pressure - rate * opening, 0.0) : pressure;
        for (int i = 0; i < 4; ++i)
            f.col(pair.vertex[i]) += share * total * nearest.weight[i] * nearest.normal;
        double fading = 0;
        if (fade.slope > 0) {
            const double energy = both.barrier.energy(gap);
            const PairPoints more = fading_force(pair, at, fade, energy);
            for (int i = 0; i < 4; ++i) f.col(pair.vertex[i]) += more.col(i);
            fading = fading_stiffness(pair, at, fade, energy);
        }
        touches_.push_back({pair, nearest, share * total, share * stiffness, share * rate, fading});
        result.dissipated += share * (pressure - total) * opening;
    }
    limit_modes(result.limits);
    result.contacts = static_cast<int>(touches_.size());
    return result;
}

// Gershgorin: each vertex's row sums over all its pairs. Weights of each piece add up to one.
void SelfContact::limit_modes(ContactLimits& limits) {
    for (const Touch& touch : touches_) {
        const double stiffness = 2 * touch.stiffness;
        const double damping = damping_ == NormalDamping::force ? 2 * touch.damping : 0;
        for (int i = 0; i < 4; ++i) {
            const double weight = std::abs(touch.nearest.weight[i]);
            rows_.col(touch.pair.vertex[i]) +=
                Eigen::Vector2d(weight * stiffness + touch.fading, weight * damping);
        }
    }
    for (const Touch& touch : touches_) {
        for (const int v : touch.pair.vertex) {
            limits.omega_squared = std::max(limits.omega_squared, rows_(0, v) * model_.inverse_mass[v]);
            limits.gamma = std::max(limits.gamma, rows_(1, v) * model_.inverse_mass[v]);
            rows_.col(v).setZero();
        }
    }
}

ContactWork SelfContact::rub(Points& v, double h) const {
    ContactWork work;
    for (const Touch& touch : touches_) {
        const SelfPair& pair = touch.pair;
        const Nearest& nearest = touch.nearest;
        Vec3 relative = Vec3::Zero();
        double inverse_mass = 0;  // how easily an impulse between the two points moves them apart [1/kg]
        for (int i = 0; i < 4; ++i) {
            relative += nearest.weight[i] * v.col(pair.vertex[i]);
            inverse_mass += nearest.weight[i] * nearest.weight[i] * model_.inverse_mass[pair.vertex[i]];
        }
        if (inverse_mass == 0) continue;
        const double damping = damping_ == NormalDamping::impulse ? touch.damping * h : 0;
        const Vec3 impulse = contact_impulse(
            {nearest.normal, touch.normal_force * h, damping, layers(pair).friction}, relative, inverse_mass);
        for (int i = 0; i < 4; ++i) {
            const int k = pair.vertex[i];
            if (model_.inverse_mass[k] == 0)
                work.driven -= nearest.weight[i] * impulse.dot(v.col(k));
            else
                v.col(k) += nearest.weight[i] * model_.inverse_mass[k] * impulse;
        }
        work.dissipated -= impulse.dot(relative + inverse_mass / 2 * impulse);
    }
    return work;
}

void SelfContact::list_grips(std::vector<Grip>& grips) const {
    for (const Touch& touch : touches_) {
        const double most = layers(touch.pair).friction * touch.normal_force;
        if (!(most > 0)) continue;
        Grip grip{{}, {}, 4, touch.nearest.normal, Vec3::Zero(), most};
        std::copy_n(touch.pair.vertex, 4, grip.vertex);
        std::copy_n(touch.nearest.weight, 4, grip.weight);
        grips.push_back(grip);
    }
}

// The distance changes by no more than the vertices move apart, so the pair may go as far as its distance
// allows, look again, and go on (conservative advancement).
double SelfContact::clear_part(const SelfPair& pair, const PairPoints& at, const PairPoints& way,
                               double most) const {
    constexpr int most_looks = 200;
    const Vec3 together = way.rowwise().mean();
    double length = 0, beside = 0;  // of the farther vertex of either piece
    for (int i = 0; i < 4; ++i) {
        double& side = i < (pair.edges ? 2 : 1) ? length : beside;
        side = std::max(side, (way.col(i) - together).norm());
    }
    length += beside;
    if (length == 0) return most;
    double gap = nearest_of(pair, at).distance, part = 0;
    if (gap == 0) return 0;
    const double kept = kept_part * std::min(gap, layers(pair).barrier.thickness);
    for (int look = 0; look < most_looks; ++look) {
        part += (gap - kept) / length;
        if (part >= most) return most;
        gap = nearest_of(pair, at + part * way).distance;
        if (gap - kept < 0.01 * kept) break;
    }
    return part;
}

double SelfContact::clear_part(In x, In move) {
    const double apart = near_drift_.of(move);
    const double longest = farthest_move * search_.mean_edge();
    double clear = apart > longest ? longest / apart : 1;
    cover(x, clear * apart);
    for (const SelfPair& pair : near_)
        clear = clear_part(pair, points_of(pair, x.data()), points_of(pair, move.data()), clear);
    return clear;
}

bool SelfContact::passed_through(In before, In after) {
    cover(before, near_drift_.of(after - before));
    return std::any_of(near_.begin(), near_.end(), [&](const SelfPair& pair) {
        const double least = kept_part * layers(pair).barrier.thickness;
        if (separation(pair, before.data()) > least && separation(pair, after.data()) > least) return false;
        const PairPoints at = points_of(pair, before.data());
        return clear_part(pair, at, points_of(pair, after.data()) - at, 1) < 1;
    });
}

void SelfContact::demand_apart(In x) {
    const Crossings found = crossings(x);
    if (found.pairs > 0)
        throw Error(cat("cloth that meets itself starts crossing: ", found.triangles, " triangles in ",
                        found.pairs, " pairs, the first ", found.first[0], " and ", found.first[1],
                        " (move them apart, or self_contact = false)"));
    cover(x, 0);
    for (const SelfPair& pair : near_) {
        const double gap = nearest_of(pair, points_of(pair, x.data())).distance;
        const double least = least_start * layers(pair).barrier.thickness;
        if (gap < least)
            throw Error(cat("cloth that meets itself starts ", gap, " m from itself at vertices ",
                            pair.vertex[0], " and ", pair.vertex[3], " (at least ", least,
                            " m, a hundredth of the thickness)"));
    }
}

}  // namespace drape
