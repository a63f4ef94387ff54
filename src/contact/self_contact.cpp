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
constexpr double least_start = 0.01;   // of the thickness, between layers at the start

std::vector<std::pair<int, int>> ranges_of(const Model& surfaces) {
    std::vector<std::pair<int, int>> ranges;
    for (const Cloth& cloth : surfaces.cloths)
        if (cloth.self_contact) ranges.emplace_back(cloth.first, cloth.vertices());
    return ranges;
}

Faces faces_of(const Model& surfaces, std::vector<int>& surface) {
    Eigen::Index count = 0;
    for (const Cloth& cloth : surfaces.cloths) count += cloth.self_contact ? cloth.mesh.triangles() : 0;
    Faces faces(3, count);
    count = 0;
    for (size_t s = 0; s < surfaces.cloths.size(); ++s) {
        const Cloth& cloth = surfaces.cloths[s];
        if (!cloth.self_contact) continue;
        faces.middleCols(count, cloth.mesh.triangles()) = cloth.mesh.faces.array() + cloth.first;
        count += cloth.mesh.triangles();
        surface.resize(static_cast<size_t>(count), static_cast<int>(s));
    }
    return faces;
}

}  // namespace

std::unique_ptr<SelfContact> SelfContact::make(const Model& model, const std::vector<Obstacle>& obstacles,
                                               const Vec3& gravity, const State& start, double duration) {
    Surfaces surfaces(model, obstacles);
    if (surfaces.meshes() == 0 && std::none_of(model.cloths.begin(), model.cloths.end(),
                                               [](const Cloth& cloth) { return cloth.self_contact; }))
        return nullptr;
    std::vector<Layers> layers = layers_between(surfaces, model, gravity, start, duration);
    std::vector<double> thickness;
    for (const Layers& both : layers) thickness.push_back(both.barrier.thickness);
    return std::unique_ptr<SelfContact>(new SelfContact(std::move(surfaces), std::move(layers), thickness));
}

SelfContact::SelfContact(Surfaces surfaces, std::vector<Layers> layers, const std::vector<double>& thickness)
    : surfaces_(std::move(surfaces)),
      faces_(faces_of(surfaces_.model(), surface_)),
      layers_(std::move(layers)),
      search_(surfaces_.model(), thickness, surfaces_.meshes()),
      thickness_(*std::max_element(thickness.begin(), thickness.end())),
      found_drift_(ranges_of(surfaces_.model())),
      near_drift_(ranges_of(surfaces_.model())),
      rows_(Eigen::Matrix2Xd::Zero(2, surfaces_.model().vertices())) {}

const Barrier& SelfContact::barrier(int surface, int other) const {
    return layers_[static_cast<size_t>(layers_of(surface, other, surfaces_.count()))].barrier;
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

double SelfContact::energy(In cloth, double time) {
    const auto x = surfaces_.positions(cloth, time);
    cover(x, 0);
    double energy = 0;
    for (const SelfPair& pair : near_) {
        const Barrier& barrier = layers(pair).barrier;
        if (separation(pair, x.data()) < barrier.thickness)
            energy += pair_energy(pair, barrier, points_of(pair, x.data()));
    }
    return energy;
}

void SelfContact::add_conservative(In cloth, double time, Out f) {
    const auto x = surfaces_.positions(cloth, time);
    const auto push = [&](int vertex, const Vec3& force) {
        if (vertex < surfaces_.columns()) f.col(vertex) += force;
    };
    cover(x, 0);
    for (SelfPair& pair : near_) {
        const Barrier& barrier = layers(pair).barrier;
        if (separation(pair, x.data()) >= barrier.thickness) continue;
        const PairPoints at = points_of(pair, x.data());
        const Nearest nearest = measure(pair, at);
        if (nearest.distance >= barrier.thickness || nearest.distance == 0) continue;  // caught by add_all
        const Fade fade = fade_of(pair, at);
        const double pressure = pair.area * fade.part * barrier.pressure(nearest.distance);
        for (int i = 0; i < 4; ++i) push(pair.vertex[i], pressure * nearest.weight[i] * nearest.normal);
        if (fade.slope == 0) continue;
        const PairPoints more = fading_force(pair, at, fade, barrier.energy(nearest.distance));
        for (int i = 0; i < 4; ++i) push(pair.vertex[i], more.col(i));
    }
}

ObstacleContact::Result SelfContact::add_all(In cloth, In moving, double time, Out f, NormalDamping damping) {
    const auto x = surfaces_.positions(cloth, time), v = surfaces_.velocities(moving, time);
    cover(x, v);
    touches_.clear();
    damping_ = damping;
    ObstacleContact::Result result;
    const auto push = [&](int vertex, const Vec3& force) {
        if (vertex < surfaces_.columns())
            f.col(vertex) += force;
        else  // what moves the mesh works against it
            result.driven -= force.dot(v.col(vertex));
    };
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
        for (int i = 0; i < 4; ++i) push(pair.vertex[i], share * total * nearest.weight[i] * nearest.normal);
        double fading = 0;
        if (fade.slope > 0) {
            const double energy = both.barrier.energy(gap);
            const PairPoints more = fading_force(pair, at, fade, energy);
            for (int i = 0; i < 4; ++i) push(pair.vertex[i], more.col(i));
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
    const Eigen::VectorXd& inverse_mass = surfaces_.model().inverse_mass;
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
            limits.omega_squared = std::max(limits.omega_squared, rows_(0, v) * inverse_mass[v]);
            limits.gamma = std::max(limits.gamma, rows_(1, v) * inverse_mass[v]);
            rows_.col(v).setZero();
        }
    }
}

ContactWork SelfContact::rub(Points& v, double h) const {
    const Eigen::VectorXd& inverse_mass = surfaces_.model().inverse_mass;
    ContactWork work;
    for (const Touch& touch : touches_) {
        const SelfPair& pair = touch.pair;
        const Nearest& nearest = touch.nearest;
        Vec3 relative = Vec3::Zero();
        double yielding = 0;  // how easily an impulse between the two points moves them apart [1/kg]
        for (int i = 0; i < 4; ++i) {
            relative += nearest.weight[i] * surfaces_.velocity(v, pair.vertex[i]);
            yielding += nearest.weight[i] * nearest.weight[i] * inverse_mass[pair.vertex[i]];
        }
        if (yielding == 0) continue;
        const double damping = damping_ == NormalDamping::impulse ? touch.damping * h : 0;
        const Vec3 impulse = contact_impulse(
            {nearest.normal, touch.normal_force * h, damping, layers(pair).friction}, relative, yielding);
        for (int i = 0; i < 4; ++i) {
            const int k = pair.vertex[i];
            if (inverse_mass[k] == 0)
                work.driven -= nearest.weight[i] * impulse.dot(surfaces_.velocity(v, k));
            else
                v.col(k) += nearest.weight[i] * inverse_mass[k] * impulse;
        }
        work.dissipated -= impulse.dot(relative + yielding / 2 * impulse);
    }
    return work;
}

void SelfContact::list_grips(std::vector<Grip>& grips) const {
    for (const Touch& touch : touches_) {
        const double most = layers(touch.pair).friction * touch.normal_force;
        if (!(most > 0)) continue;
        Grip grip{{}, {}, 0, touch.nearest.normal, Vec3::Zero(), most};
        for (int i = 0; i < 4; ++i) {
            const int v = touch.pair.vertex[i];
            if (v < surfaces_.columns()) {
                grip.vertex[grip.corners] = v;
                grip.weight[grip.corners++] = touch.nearest.weight[i];
            } else {
                grip.surface_velocity -= touch.nearest.weight[i] * surfaces_.mesh_velocity(v);
            }
        }
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

double SelfContact::clear_part(In cloth, In cloth_move, double time) {
    const auto x = surfaces_.positions(cloth, time), move = surfaces_.moves(cloth_move);
    const double apart = near_drift_.of(move);
    const double longest = farthest_move * search_.mean_edge();
    double clear = apart > longest ? longest / apart : 1;
    cover(x, clear * apart);
    for (const SelfPair& pair : near_)
        clear = clear_part(pair, points_of(pair, x.data()), points_of(pair, move.data()), clear);
    return clear;
}

bool SelfContact::passed_through(const State& from, const State& to) {
    const Points before = surfaces_.positions(from.x, from.time);
    const auto after = surfaces_.positions(to.x, to.time);
    cover(before, near_drift_.of(after - before));
    return std::any_of(near_.begin(), near_.end(), [&](const SelfPair& pair) {
        const double least = kept_part * layers(pair).barrier.thickness;
        if (separation(pair, before.data()) > least && separation(pair, after.data()) > least) return false;
        const PairPoints at = points_of(pair, before.data());
        return clear_part(pair, at, points_of(pair, after.data()) - at, 1) < 1;
    });
}

void SelfContact::demand_apart(In cloth) {
    const Crossings found = crossings(cloth, 0);
    if (found.pairs > 0) {
        const Obstacle* mesh = surfaces_.mesh(surface_[static_cast<size_t>(found.first[1])]);
        const std::string which = cat(found.triangles, " triangles in ", found.pairs, " pairs");
        if (mesh)
            throw Error(cat(mesh->place.empty() ? "" : mesh->place + ": ",
                            "cloth starts crossing the mesh: ", which, " (move one of them, or --untangle)"));
        throw Error(cat("cloth that meets itself starts crossing: ", which, ", the first ", found.first[0],
                        " and ", found.first[1], " (move them apart, --untangle, or self_contact = false)"));
    }
    const auto x = surfaces_.positions(cloth, 0);
    cover(x, 0);
    for (const SelfPair& pair : near_) {
        const double gap = nearest_of(pair, points_of(pair, x.data())).distance;
        const double least = least_start * layers(pair).barrier.thickness;
        if (gap >= least) continue;
        const Obstacle* mesh = surfaces_.mesh(pair.layers % surfaces_.count());  // numbered after the cloths
        throw Error(cat(mesh && !mesh->place.empty() ? mesh->place + ": " : "",
                        mesh ? "cloth starts " : "cloth that meets itself starts ", gap,
                        mesh ? " m from the mesh" : " m from itself", " at vertices ", pair.vertex[0],
                        " and ", pair.vertex[3], " (at least ", least, " m, a hundredth of the thickness)"));
    }
}

Crossings SelfContact::crossings(In x, double time) {
    return count_crossings(faces_, surfaces_.positions(x, time), [this](int face, int other) {
        return surfaces_.meet(surface_[static_cast<size_t>(face)], surface_[static_cast<size_t>(other)]);
    });
}

Eigen::VectorXd SelfContact::room(In cloth, double time, double reach) {
    const auto x = surfaces_.positions(cloth, time);
    std::vector<SelfPair> pairs;
    search_.find(x, reach, pairs);
    Eigen::VectorXd room = Eigen::VectorXd::Constant(surfaces_.columns(), INFINITY);
    for (const SelfPair& pair : pairs) {
        const double distance = nearest_of(pair, points_of(pair, x.data())).distance;
        for (const int v : pair.vertex)
            if (v < surfaces_.columns()) room[v] = std::min(room[v], distance);
    }
    return room;
}

double SelfContact::least_distance(In cloth, double time, bool held) {
    double least = INFINITY;
    if (surfaces_.meshes() == 0) return least;
    const auto x = surfaces_.positions(cloth, time);
    cover(x, 0);
    const auto is_held = [&](int v) { return surfaces_.model().inverse_mass[v] == 0; };
    for (const SelfPair& pair : near_) {
        if (!touches_mesh(pair)) continue;
        if (!held && std::any_of(pair.vertex, pair.vertex + 4,
                                 [&](int v) { return v < surfaces_.columns() && is_held(v); }))
            continue;
        least = std::min(least, nearest_of(pair, points_of(pair, x.data())).distance);
    }
    return least;
}

}  // namespace drape
