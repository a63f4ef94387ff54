#include "contact/self_pair.h"

#include <catch2/catch.hpp>

#include "support/cloths.h"
#include "support/gradient.h"
#include "support/matrices.h"

using namespace drape;
using namespace drape::test;

namespace {

const Barrier barrier{0.3, 5};

struct Posed {
    SelfPair pair{{0, 1, 2, 3}, 0, false, 0.7, 0};
    Points x;

    Posed(bool edges, bool parallel, unsigned seed) : x(random_points(4, 0.5, seed)) {
        pair.edges = edges;
        const Vec3 u = x.col(1) - x.col(0);
        if (parallel) x.col(3) = x.col(2) + (0.5 + 0.1 * (seed % 9)) * u + 0.1 * x.col(3);
        pair.fading = 0.01 * u.squaredNorm() * (x.col(3) - x.col(2)).squaredNorm();
    }
    PairPoints at(In moved) const { return points_of(pair, moved.data()); }
    Points force(In moved) const {
        const PairPoints p = at(moved);
        const Nearest nearest = nearest_of(pair, p);
        const Fade fade = fade_of(pair, p);
        Points f(3, 4);
        for (int i = 0; i < 4; ++i)
            f.col(i) = pair.area * fade.part * barrier.pressure(nearest.distance) * nearest.weight[i] *
                       nearest.normal;
        if (fade.slope > 0) f += fading_force(pair, p, fade, barrier.energy(nearest.distance));
        return f;
    }
};

// Calls visit with pairs well within the barrier, of every sort.
template <class Visit>
void each_pose(Visit visit) {
    for (const bool edges : {false, true})
        for (const bool parallel : {false, true})
            for (unsigned seed = 0; seed < (edges || !parallel ? 150u : 0u); ++seed) {
                const Posed posed(edges, parallel, seed);
                const double gap = nearest_of(posed.pair, posed.at(posed.x)).distance;
                if (gap > 0.05 && gap < 0.28) visit(posed);
            }
}

}  // namespace

TEST_CASE("a pair's force is minus the gradient of its potential with edges as parallel as may be",
          "[contact]") {
    int fading = 0, all = 0;
    each_pose([&](const Posed& t) {
        const Points f = t.force(t.x);
        const Points expected =
            minus_gradient([&](In x) { return pair_energy(t.pair, barrier, t.at(x)); }, t.x, 1e-5);
        CHECK((f - expected).norm() < 1e-6 * (f.norm() + 1e-3));
        CHECK(net_force(f).norm() < 1e-12 * (1 + f.norm()));
        CHECK(net_torque(t.x, f).norm() < 1e-12 * (1 + f.norm()));
        fading += fade_of(t.pair, t.at(t.x)).slope > 0;
        ++all;
    });
    CHECK(all > 100);
    CHECK(fading > 20);
}

TEST_CASE("a pair's Hessian is the slope of its force", "[contact]") {
    each_pose([&](const Posed& t) {
        const PairMatrix h = pair_hessian(t.pair, barrier, t.at(t.x));
        const int free = nearest_of(t.pair, t.at(t.x)).free;
        PairMatrix slope;
        bool same = true;  // the places stay on the same feature
        for (int c = 0; c < 12; ++c) {
            constexpr double step = 1e-6;
            Points more = t.x, less = t.x;
            more.data()[c] += step;
            less.data()[c] -= step;
            same = same && nearest_of(t.pair, t.at(more)).free == free &&
                   nearest_of(t.pair, t.at(less)).free == free;
            const Points change = (t.force(less) - t.force(more)) / (2 * step);
            slope.col(c) = Eigen::Map<const Eigen::Matrix<double, 12, 1>>(change.data());
        }
        if (same) CHECK((h - slope).norm() < 1e-6 * (h.norm() + 1));
        CHECK((h - h.transpose()).norm() < 1e-12 * (h.norm() + 1));
    });
}

TEST_CASE("what fading adds to a pair's stiffness is within its bound", "[contact]") {
    each_pose([&](const Posed& t) {
        const PairPoints x = t.at(t.x);
        const Fade fade = fade_of(t.pair, x);
        if (fade.slope == 0) return;
        const auto push = [&](In moved) {
            const PairPoints p = t.at(moved);
            return Points(fading_force(t.pair, p, fade_of(t.pair, p), 1));
        };
        const double bound = fading_stiffness(t.pair, x, fade, 1);
        Eigen::MatrixXd slope(12, 12);
        for (int c = 0; c < 12; ++c) {
            Points more = t.x, less = t.x;
            more.data()[c] += 1e-6;
            less.data()[c] -= 1e-6;
            const Points change = (push(less) - push(more)) / 2e-6;
            slope.col(c) = Eigen::Map<const Eigen::VectorXd>(change.data(), 12);
        }
        CHECK(eigenvalues(slope).cwiseAbs().maxCoeff() < 1.001 * bound);
    });
}

TEST_CASE("a pair's potential has no jump where edges become parallel or the barrier begins", "[contact]") {
    SelfPair pair{{0, 1, 2, 3}, 0, true, 1, 0.01};
    const auto energy = [&](double turned, double gap) {
        PairPoints x;
        x << 0, 1, 0.5 - 0.5 * std::cos(turned), 0.5 + 0.5 * std::cos(turned), 0, 0, gap, gap, 0, 0,
            -0.5 * std::sin(turned), 0.5 * std::sin(turned);
        return pair_energy(pair, barrier, x);
    };
    CHECK(energy(0, 0.1) == 0);
    CHECK(energy(1e-4, 0.1) < 1e-5 * energy(0.5, 0.1));
    CHECK(energy(-0.05, 0.1) == Approx(energy(0.05, 0.1)));
    CHECK(energy(0.5, 0.3) == 0);
    CHECK(energy(0.5, 0.2999) < 1e-9);
    CHECK(energy(0.05, 1e-9) > 15 * energy(0.05, 0.2));
}
