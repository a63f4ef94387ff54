// What the force between cloth and cloth changes by, for implicit methods. With c the weights, n the normal,
// p = psi' and damping's share as in obstacle_contact_matrices.cpp, a pair has
//   -df/dx = d2E/dx2 + A m b' g' c c' (x) n n',   -df/dv = A m b c c' (x) n n'
// and neither where damping has eaten up the pressure. Friction is not in here.
#include <array>

#include "contact/self_contact.h"

namespace drape {

namespace {

BlockMatrix::Element along_normal(const Nearest& nearest, double value) {
    Eigen::Matrix<double, 12, 1> gradient;
    for (int i = 0; i < 4; ++i) gradient.segment<3>(3 * i) = nearest.weight[i] * nearest.normal;
    return value * gradient * gradient.transpose();
}

}  // namespace

template <class Visit>
void SelfContact::each_press(In x, In v, Visit visit) {
    cover(x, 0);
    for (const SelfPair& pair : near_) {
        const Layers& both = layers(pair);
        if (separation(pair, x.data()) >= both.barrier.thickness) continue;
        const PairPoints at = points_of(pair, x.data());
        const Nearest nearest = nearest_of(pair, at);
        if (nearest.distance >= both.barrier.thickness || nearest.distance == 0) continue;
        double opening = 0;
        for (int i = 0; i < 4; ++i) opening += nearest.weight[i] * nearest.normal.dot(v.col(pair.vertex[i]));
        const double damping = damping_of(both, both.barrier.stiffness(nearest.distance));
        if (both.barrier.pressure(nearest.distance) > damping * opening) visit(pair, at, nearest, opening);
    }
}

long SelfContact::couplings_version(In x) {
    cover(x, 0);
    return version_;
}

void SelfContact::add_couplings(Couplings& couplings) const {
    for (const SelfPair& pair : near_) couplings.couple(pair.vertex);
}

void SelfContact::add_stiffness(In x, In v, BlockMatrix& k) {
    each_press(x, v, [&](const SelfPair& pair, const PairPoints& at, const Nearest& nearest, double opening) {
        const Layers& both = layers(pair);
        const double stiffness = both.barrier.stiffness(nearest.distance);
        const double slope =
            damping_of(both, stiffness) * both.barrier.stiffness_slope(nearest.distance) / (2 * stiffness);
        const double share = pair.area * fade_of(pair, at).part;
        k.add_element(pair.vertex,
                      pair_hessian(pair, both.barrier, at) + along_normal(nearest, share * slope * opening));
    });
}

void SelfContact::add_damping(In x, In v, BlockMatrix& b) {
    each_press(x, v, [&](const SelfPair& pair, const PairPoints& at, const Nearest& nearest, double) {
        const Layers& both = layers(pair);
        const double share = pair.area * fade_of(pair, at).part;
        b.add_element(
            pair.vertex,
            along_normal(nearest, share * damping_of(both, both.barrier.stiffness(nearest.distance))));
    });
}

}  // namespace drape
