#include "force/edge_spring.h"

#include <array>
#include <cmath>

#include "force/edge_projection.h"
#include "force/kinds.h"

namespace drape {

EdgeSprings::EdgeSprings(const std::vector<Spring>& springs, int first_vertex)
    : sweep_(springs, first_vertex) {
    for (const Spring& spring : springs) {
        a_.push_back(first_vertex + spring.a);
        b_.push_back(first_vertex + spring.b);
        rest_length_.push_back(spring.rest_length);
        stiffness_.push_back(spring.stiffness);
        damping_.push_back(spring.damping);
        damped_ = damped_ || spring.damping > 0;
    }
}

EdgeSprings::~EdgeSprings() = default;

double EdgeSprings::energy(In x) const {
    double energy = 0;
    for (size_t s = 0; s < a_.size(); ++s) {
        const double stretch = (x.col(a_[s]) - x.col(b_[s])).norm() - rest_length_[s];
        energy += 0.5 * stiffness_[s] * stretch * stretch;
    }
    return energy;
}

void EdgeSprings::add_padded_conservative(const PaddedPoints& x, PaddedPoints& f) const {
    sweep_.pull(x, f);
}

Power EdgeSprings::add_padded(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const {
    return {sweep_.pull_damped(x, v, f), 0};
}

// The spring's block is c n n' + c (1 - l0/l)(I - n n'), of norm c in tension; in compression its transverse
// part is negative, which buckles and does not vibrate. A row holds it twice: for itself and for its partner.
void EdgeSprings::add_bound(In, StepBound& bound) const {
    for (size_t s = 0; s < a_.size(); ++s) {
        for (const int end : {a_[s], b_[s]}) {
            bound.stiffness[end] += 2 * stiffness_[s];
            bound.damping[end] += 2 * damping_[s];
        }
    }
}

void EdgeSprings::add_couplings(Couplings& couplings) const {
    for (size_t s = 0; s < a_.size(); ++s) couplings.couple(std::array{a_[s], b_[s]});
}

namespace {

// what acts on the difference of two ends acts on each, and against the other
BlockMatrix::Element between_ends(const Mat3& k) {
    BlockMatrix::Element element(6, 6);
    element << k, -k, -k, k;
    return element;
}

}  // namespace

// grad l = n and grad n = (I - n n') / l, so K = c n n' + c (1 - l0/l) (I - n n').
void EdgeSprings::add_stiffness(In x, BlockMatrix& k) const {
    for (size_t s = 0; s < a_.size(); ++s) {
        const Vec3 along = x.col(a_[s]) - x.col(b_[s]);
        const double length = along.norm();
        if (length == 0 && rest_length_[s] > 0) continue;
        const double across = rest_length_[s] > 0 ? 1 - rest_length_[s] / length : 1;
        const Vec3 n = length > 0 ? Vec3(along / length) : Vec3::Zero();
        k.add_element(
            std::array{a_[s], b_[s]},
            between_ends(stiffness_[s] * (across * Mat3::Identity() + (1 - across) * n * n.transpose())));
    }
}

void EdgeSprings::add_damping(In x, In, double, BlockMatrix& b) const {
    if (!damped_) return;
    for (size_t s = 0; s < a_.size(); ++s) {
        const Vec3 along = x.col(a_[s]) - x.col(b_[s]);
        const double length = along.norm();
        if (length == 0) continue;
        const Vec3 n = along / length;
        b.add_element(std::array{a_[s], b_[s]}, between_ends(damping_[s] * n * n.transpose()));
    }
}

// Along the spring K is c, across it c (1 - l0/l) < c at any length.
void EdgeSprings::add_stiffness_majorant(Majorant& k) const {
    for (size_t s = 0; s < a_.size(); ++s) k.add_difference(a_[s], b_[s], stiffness_[s]);
}

void EdgeSprings::add_damping_majorant(Majorant& b) const {
    for (size_t s = 0; s < a_.size(); ++s) b.add_difference(a_[s], b_[s], damping_[s]);
}

void EdgeSprings::project(WeightedPoints& x, const WeightedPoints& before, double h) {
    if (!projection_)
        projection_ = std::make_unique<EdgeProjection>(a_, b_, rest_length_, stiffness_, damping_);
    projection_->sweep(x, before, h);
}

MadeForce make_edge_springs(const Cloth& cloth, const Surroundings&) {
    if (cloth.network.edges.empty()) return {nullptr, "no edges"};
    if (cloth.fabric.membrane != MembraneKind::none)
        return {nullptr, "finite elements take their place (membrane)"};
    if (cloth.fabric.stretch == 0) return {nullptr, "stretch is 0"};
    return {std::make_unique<EdgeSprings>(cloth.network.edges, cloth.first), "along every mesh edge"};
}

}  // namespace drape
