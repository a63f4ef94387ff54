#include "contact/untangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "contact/neighbours.h"

namespace drape {

namespace {

constexpr double longest_move = 0.25;  // of a vertex in a round, in mean edges
constexpr int most_rounds = 2000;
constexpr int most_in_vain = 300;    // rounds without fewer crossings or shorter curves
constexpr double wanted_gap = 0.5;   // of the thickness, when pairs are pushed apart
constexpr double enough_gap = 0.25;  // ... and they may stay at

// Where an edge of one triangle pierces the other.
struct Piercing {
    std::array<int, 2> edge{};
    std::array<int, 3> corner{};
    double along = 0;  // the edge, from its first end
    Vec3 at = Vec3::Zero();
    Vec3 share = Vec3::Zero();  // of each corner in that place
};

// Of the vertex, which two triangles share, or of an edge and a triangle.
struct End {
    Vec3 at;
    int shared = -1;
    Piercing piercing = {};
};

std::optional<Piercing> piercing(In x, std::array<int, 2> edge, std::array<int, 3> corner) {
    const Vec3 p = x.col(edge[0]), q = x.col(edge[1]);
    const Vec3 a = x.col(corner[0]), b = x.col(corner[1]), c = x.col(corner[2]);
    const Vec3 normal = (b - a).cross(c - a);
    const double above = normal.dot(p - a), below = normal.dot(q - a);
    if (!(above * below < 0)) return std::nullopt;
    const double along = above / (above - below), area = normal.squaredNorm();
    const Vec3 at = p + along * (q - p);
    const Vec3 share((c - b).cross(at - b).dot(normal) / area, (a - c).cross(at - c).dot(normal) / area,
                     (b - a).cross(at - a).dot(normal) / area);
    if (share.minCoeff() < 0) return std::nullopt;
    return Piercing{edge, corner, along, at, share};
}

std::array<int, 3> corners(const Faces& faces, int face) {
    return {faces(0, face), faces(1, face), faces(2, face)};
}

// Of the segment that two triangles share; none or one of those that only touch.
std::vector<End> ends_of(In x, const std::array<int, 3>& one, const std::array<int, 3>& two) {
    std::vector<End> ends;
    for (const auto& [through, pierced] : {std::pair(one, two), std::pair(two, one)})
        for (size_t k = 0; k < 3; ++k) {
            const std::array<int, 2> edge{through[k], through[(k + 1) % 3]};
            const auto touches = [&](int v) { return v == edge[0] || v == edge[1]; };
            if (std::any_of(pierced.begin(), pierced.end(), touches)) continue;
            if (const auto found = piercing(x, edge, pierced)) ends.push_back({found->at, -1, *found});
        }
    for (const int v : one)
        if (std::find(two.begin(), two.end(), v) != two.end()) ends.push_back({x.col(v), v});
    return ends;
}

// Adds what moves of the vertices around an end do to the length of a segment that goes from it along
// `inwards`.
void add_gradient(const End& end, const Vec3& inwards, In x, Points& gradient) {
    if (end.shared >= 0) {
        gradient.col(end.shared) -= inwards;
        return;
    }
    const Piercing& p = end.piercing;
    const Vec3 edge = x.col(p.edge[1]) - x.col(p.edge[0]);
    const Vec3 a = x.col(p.corner[0]);
    const Vec3 normal = (x.col(p.corner[1]) - a).cross(x.col(p.corner[2]) - a);
    const Vec3 across = normal * (inwards.dot(edge) / normal.dot(edge));
    gradient.col(p.edge[0]) += (1 - p.along) * (across - inwards);
    gradient.col(p.edge[1]) += p.along * (across - inwards);
    for (int k = 0; k < 3; ++k) gradient.col(p.corner[static_cast<size_t>(k)]) -= p.share[k] * across;
}

class Untangling {
public:
    Untangling(const Model& model, const std::vector<Obstacle>& obstacles, const Vec3& gravity, State& start,
               double duration)
        : x_(start.x),
          contact_(SelfContact::make(model, obstacles, gravity, start, duration)),
          neighbours_(model, start.x) {}

    Untangled go() {
        Untangled done;
        if (!contact_) return done;
        Crossings found = contact_->crossings(x_, 0);
        done.before = found;
        if (found.pairs == 0) return done;
        const Points start = x_;
        // gaps of round-off may close again while layers are parted
        for (; found.pairs > 0; found = contact_->crossings(x_, 0)) {
            draw_out(std::move(found), done);
            done.rounds += part();
        }
        done.largest_move = std::sqrt((x_ - start).colwise().squaredNorm().maxCoeff());
        return done;
    }

private:
    void draw_out(Crossings found, Untangled& done) {
        double shortest = INFINITY;
        for (int in_vain = 0; found.pairs > 0; ++done.rounds, found = contact_->crossings(x_, 0)) {
            const double length = shorten_curves(found);
            in_vain = length < shortest ? 0 : in_vain + 1;
            shortest = std::min(shortest, length);
            if (done.rounds >= most_rounds || in_vain == most_in_vain)
                throw Error(cat("cloth cannot be untangled: ", found.pairs,
                                " pairs of triangles cross after ", done.rounds, " rounds, ",
                                done.before.pairs,
                                " did at the start (--untangle draws out corners and folds, not sheets that "
                                "cross from border to border)"));
        }
    }

    // One round; the length of all curves before it [m].
    double shorten_curves(const Crossings& found) {
        const Points all = contact_->positions(x_, 0);
        Points gradient = Points::Zero(3, all.cols());
        double length = 0;
        for (const auto& [face, other] : found.which) {
            const std::vector<End> ends =
                ends_of(all, corners(contact_->faces(), face), corners(contact_->faces(), other));
            for (const int f : {face, other})
                for (const int v : corners(contact_->faces(), f))
                    if (v < x_.cols()) neighbours_.relax(v);
            if (ends.size() < 2) continue;
            const Vec3 way = ends[1].at - ends[0].at;
            const double size = way.norm();
            if (size == 0) continue;
            length += size;
            add_gradient(ends[0], way / size, all, gradient);
            add_gradient(ends[1], -way / size, all, gradient);
        }
        // steep where an edge all but lies in the triangle that it pierces
        Points move = -gradient.leftCols(x_.cols());
        for (Eigen::Index i = 0; i < move.cols(); ++i) move.col(i) /= std::max(1.0, move.col(i).norm());
        neighbours_.smooth(move);
        const double longest = std::sqrt(move.colwise().squaredNorm().maxCoeff());
        if (longest > 0) x_ += move * (longest_move * contact_->mean_edge() / longest);
        neighbours_.keep_lengths(x_);
        return length;
    }

    // Pushes pairs apart that are nearer than contact can start from; how many rounds that took.
    int part() {
        for (int round = 0; round < most_rounds; ++round) {
            Points move = Points::Zero(3, x_.cols());
            if (contact_->push_apart(x_, wanted_gap, move) >= enough_gap) return round;
            // lengths by turns: they must not press together for good what is to part
            if (round % 2 == 1) {
                Points there = x_ + move;
                neighbours_.keep_lengths(there);
                move = there - x_;
            }
            x_ += contact_->clear_part(x_, move, 0) * move;
        }
        throw Error(
            "cloth is untangled, but its layers cannot be parted by a quarter of their thickness "
            "(thinner fabric, or more room)");
    }

    Points& x_;
    std::unique_ptr<SelfContact> contact_;
    Neighbours neighbours_;
};

}  // namespace

Untangled untangle(const Model& model, const std::vector<Obstacle>& obstacles, const Vec3& gravity,
                   State& start, double duration) {
    return Untangling(model, obstacles, gravity, start, duration).go();
}

double SelfContact::push_apart(In cloth, double share, Points& move) {
    const auto x = surfaces_.positions(cloth, 0);
    const Eigen::VectorXd& inverse_mass = surfaces_.model().inverse_mass;
    std::vector<SelfPair> pairs;
    search_.find(x, share * thickness_, pairs);
    double nearest_share = INFINITY;
    Points push = Points::Zero(3, cloth.cols());
    Eigen::VectorXd urgencies = Eigen::VectorXd::Zero(cloth.cols());
    for (const SelfPair& pair : pairs) {
        const Nearest nearest = nearest_of(pair, points_of(pair, x.data()));
        const double thickness = layers(pair).barrier.thickness;
        nearest_share = std::min(nearest_share, nearest.distance / thickness);
        double yielding = 0;
        for (int i = 0; i < 4; ++i)
            if (inverse_mass[pair.vertex[i]] > 0) yielding += nearest.weight[i] * nearest.weight[i];
        const double missing = share * thickness - nearest.distance;
        if (yielding == 0 || missing <= 0) continue;
        // the nearest, which stops all others, has the most to say
        const double urgency = thickness / nearest.distance;
        for (int i = 0; i < 4; ++i) {
            const int v = pair.vertex[i];
            if (inverse_mass[v] == 0 || nearest.weight[i] == 0) continue;
            push.col(v) += urgency * missing / yielding * nearest.weight[i] * nearest.normal;
            urgencies[v] += urgency * std::abs(nearest.weight[i]);
        }
    }
    for (Eigen::Index i = 0; i < move.cols(); ++i)
        if (urgencies[i] > 0) move.col(i) += push.col(i) / urgencies[i];
    return nearest_share;
}

}  // namespace drape
