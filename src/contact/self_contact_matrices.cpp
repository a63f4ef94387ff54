// What the force between cloth and cloth changes by, for implicit methods. With c the weights, n the normal,
// p = psi' and damping's share as in obstacle_contact_matrices.cpp, a pair has
//   -df/dx = d2E/dx2 + A m b' g' c c' (x) n n',   -df/dv = A m b c c' (x) n n'
// and neither where damping has eaten up the pressure. Friction is not in here.
#include <array>

#include "contact/self_contact.h"

namespace drape {

namespace {

PairMatrix along_normal(const Nearest& nearest, double value) {
    Eigen::Matrix<double, 12, 1> gradient;
    for (int i = 0; i < 4; ++i) gradient.segment<3>(3 * i) = nearest.weight[i] * nearest.normal;
    return value * gradient * gradient.transpose();
}

}  // namespace

template <class Visit>
void SelfContact::each_press(In cloth, In moving, double time, Visit visit) {
    const auto x = surfaces_.positions(cloth, time), v = surfaces_.velocities(moving, time);
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

namespace {

// those of a pair's vertices that are columns of the State, as places in the pair
int free_corners(const SelfPair& pair, int columns, int (&corner)[4]) {
    int count = 0;
    for (int i = 0; i < 4; ++i)
        if (pair.vertex[i] < columns) corner[count++] = i;
    return count;
}

}  // namespace

long SelfContact::couplings_version(In x, double time) {
    cover(surfaces_.positions(x, time), 0);
    return version_;
}

void SelfContact::add_couplings(Couplings& couplings) const {
    for (const SelfPair& pair : near_) {
        int corner[4], vertex[4];
        const int count = free_corners(pair, surfaces_.columns(), corner);
        for (int i = 0; i < count; ++i) vertex[i] = pair.vertex[corner[i]];
        couplings.couple({vertex, static_cast<size_t>(count)});
    }
}

// A mesh's vertices have no rows.
void SelfContact::add_element(const SelfPair& pair, const PairMatrix& value, BlockMatrix& matrix) const {
    int corner[4], vertex[4];
    const int count = free_corners(pair, surfaces_.columns(), corner);
    BlockMatrix::Element element(3 * count, 3 * count);
    for (int i = 0; i < count; ++i) {
        vertex[i] = pair.vertex[corner[i]];
        for (int j = 0; j < count; ++j)
            element.block<3, 3>(3 * i, 3 * j) = value.block<3, 3>(3 * corner[i], 3 * corner[j]);
    }
    matrix.add_element({vertex, static_cast<size_t>(count)}, element);
}

void SelfContact::add_stiffness(In x, In v, double time, BlockMatrix& k) {
    each_press(
        x, v, time, [&](const SelfPair& pair, const PairPoints& at, const Nearest& nearest, double opening) {
            const Layers& both = layers(pair);
            const double stiffness = both.barrier.stiffness(nearest.distance);
            const double slope = damping_of(both, stiffness) *
                                 both.barrier.stiffness_slope(nearest.distance) / (2 * stiffness);
            const double share = pair.area * fade_of(pair, at).part;
            add_element(pair,
                        pair_hessian(pair, both.barrier, at) + along_normal(nearest, share * slope * opening),
                        k);
        });
}

void SelfContact::add_damping(In x, In v, double time, BlockMatrix& b) {
    each_press(x, v, time, [&](const SelfPair& pair, const PairPoints& at, const Nearest& nearest, double) {
        const Layers& both = layers(pair);
        const double share = pair.area * fade_of(pair, at).part;
        const double damping = damping_of(both, both.barrier.stiffness(nearest.distance));
        add_element(pair, along_normal(nearest, share * damping), b);
    });
}

}  // namespace drape
