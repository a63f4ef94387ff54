#include "contact/obstacle_contact.h"

#include <catch2/catch.hpp>

#include "support/gradient.h"
#include "support/matrices.h"
#include "support/touching.h"

using namespace drape;
using namespace drape::test;

namespace {

// The matrix of a linear map of all coordinates, by central differences.
template <class Map>
Eigen::MatrixXd jacobian(const Points& at, double h, Map map) {
    Eigen::MatrixXd columns(at.size(), at.size());
    Points p = at;
    for (Eigen::Index i = 0; i < p.size(); ++i) {
        const double kept = p.data()[i];
        p.data()[i] = kept + h;
        const Points after = map(p);
        p.data()[i] = kept - h;
        const Points before = map(p);
        p.data()[i] = kept;
        columns.col(i) = (after - before).reshaped() / (2 * h);
    }
    return columns;
}

// The largest eigenvalue of M^-1 K for a symmetric K.
double largest_mode(const Eigen::MatrixXd& stiffness, const Model& model) {
    const Eigen::VectorXd root =
        model.inverse_mass.cwiseSqrt().transpose().replicate(3, 1).reshaped();  // three alike per vertex
    const Eigen::MatrixXd scaled = root.asDiagonal() * stiffness * root.asDiagonal();
    return eigenvalues(scaled).maxCoeff();
}

}  // namespace

TEST_CASE("contact's force is minus the gradient of its energy, on every obstacle, at rest and moving",
          "[contact]") {
    unsigned seed = 10;
    for (const auto& [name, obstacle] : every_obstacle()) {
        Touching t(obstacle, ++seed);
        CAPTURE(name, t.contact.level());
        Points f = Points::Zero(3, t.x.cols());
        t.contact.add_conservative(t.x, t.time, f);
        REQUIRE(f.norm() > 0);
        const Points expected = minus_gradient([&](In y) { return t.contact.energy(y, t.time); }, t.x, 1e-6);
        CHECK((f - expected).norm() / f.norm() < 1e-7);  // measured: below 1e-9

        // nothing else pushes a cloth that goes with the obstacle
        const MovingPose moving = obstacle.motion.at(t.time);
        for (Eigen::Index i = 0; i < t.x.cols(); ++i) t.v.col(i) = moving.velocity_at(t.x.col(i));
        Points all = Points::Zero(3, t.x.cols());
        const ObstacleContact::Result result = t.contact.add_all(t.x, t.v, t.time, all);
        CHECK((f - all).norm() < 1e-12 * f.norm());
        CHECK(result.contacts > 0);
        CHECK(!result.crossed);
    }
}

TEST_CASE("what contact gives the cloth is what its potential loses and the obstacle drives, less the heat",
          "[contact]") {
    unsigned seed = 50;
    for (const auto& [name, obstacle] : every_obstacle()) {
        Touching t(obstacle, ++seed);
        CAPTURE(name);
        Points f = Points::Zero(3, t.x.cols());
        const ObstacleContact::Result result = t.contact.add_all(t.x, t.v, t.time, f);
        const double given = f.cwiseProduct(t.v).sum();
        const auto energy_at = [&](double later) {
            return t.contact.energy(t.x + later * t.v, t.time + later);
        };
        const double h = 1e-7, lost = (energy_at(-h) - energy_at(h)) / (2 * h);
        const double size = std::abs(given) + std::abs(lost) + result.dissipated + std::abs(result.driven);
        CHECK(given == Approx(lost + result.driven - result.dissipated).margin(1e-6 * size));
        CHECK(result.dissipated > 0);
        if (!obstacle.motion.moves()) CHECK(result.driven == 0);
    }
}

TEST_CASE("contact's damping only takes energy, and contact never pulls, however fast the cloth leaves",
          "[contact]") {
    for (const double speed : {0.01, 1.0, 100.0}) {
        for (const double direction : {-1.0, 1.0}) {
            Touching t(obstacle_of("plane", {}), 3);
            t.v.setZero();
            t.v.row(1).setConstant(direction * speed);
            CAPTURE(speed, direction);
            Points f = Points::Zero(3, t.x.cols()), barrier = f;
            const ObstacleContact::Result result = t.contact.add_all(t.x, t.v, t.time, f);
            t.contact.add_conservative(t.x, t.time, barrier);
            CHECK(result.dissipated > 0);
            CHECK(f.row(1).minCoeff() >= 0);
            CHECK((direction * (barrier - f).row(1)).minCoeff() >= 0);  // against the motion
            if (direction > 0 && speed == 100) CHECK(f.norm() == 0);
        }
    }
}

TEST_CASE("contact's limits hold its fastest and its most damped mode, at every level of points",
          "[contact]") {
    unsigned seed = 90;
    for (const auto& [name, obstacle] : every_obstacle()) {
        Touching t(obstacle, ++seed);
        CAPTURE(name, t.contact.level());
        Points f = Points::Zero(3, t.x.cols());
        t.v *= 1e-3;  // slow enough that damping nowhere cancels the barrier
        const ContactLimits limits = t.contact.add_all(t.x, t.v, t.time, f).limits;
        const Eigen::MatrixXd stiffness = -jacobian(t.x, 1e-7, [&](const Points& x) {
            Points force = Points::Zero(3, x.cols());
            t.contact.add_conservative(x, t.time, force);
            return force;
        });
        const Eigen::MatrixXd damping = -jacobian(t.v, 1e-4, [&](const Points& v) {
            Points force = Points::Zero(3, v.cols());
            t.contact.add_all(t.x, v, t.time, force);
            return force;
        });
        const double omega_squared = largest_mode(stiffness, t.model), gamma = largest_mode(damping, t.model);
        CHECK(omega_squared <= limits.omega_squared * (1 + 1e-6));
        CHECK(gamma <= limits.gamma * (1 + 1e-6));
        CHECK(omega_squared >= 0.5 * limits.omega_squared);  // measured: 0.69 to 1
    }
}

TEST_CASE("a step as long as the closing rate allows uses at most a quarter of the gap in the barrier",
          "[contact]") {
    Touching t(obstacle_of("plane", {}), 4);
    t.v.setZero();
    t.v.row(1).setConstant(-50);
    Points f = Points::Zero(3, t.x.cols());
    const ContactLimits limits = t.contact.add_all(t.x, t.v, t.time, f).limits;
    const double gap = t.x.row(1).minCoeff();
    REQUIRE(gap < t.contact.barrier().thickness);
    CHECK(50 / limits.closing_rate == Approx(gap / 4));

    // and from outside never beyond the same quarter of the thickness
    const double d = t.contact.barrier().thickness;
    t.x.row(1).array() += 10 * d - gap;
    t.contact.add_all(t.x, t.v, t.time, f);
    CHECK(50 / t.contact.add_all(t.x, t.v, t.time, f).limits.closing_rate == Approx(9 * d + d / 4));
}

TEST_CASE("the level of contact points keeps what a triangle dips between them within half the thickness",
          "[contact]") {
    for (const auto& [name, obstacle] : every_obstacle()) {
        if (obstacle.motion.moves()) continue;
        CAPTURE(name);
        const Touching t(obstacle, 5);
        double longest = 0;
        for (const Spring& edge : t.model.cloths[0].network.edges)
            longest = std::max(longest, edge.rest_length);
        CHECK(t.contact.offset() >= obstacle.solid->sagitta(longest / t.contact.level()));
        CHECK(t.contact.offset() <= t.contact.barrier().thickness / 2);
        CHECK((t.contact.level() == 1 || obstacle.solid->sagitta(1.05 * longest / (t.contact.level() - 1)) >
                                             t.contact.barrier().thickness / 2));
    }
}

TEST_CASE("the least distance of a cloth is that of a fine lattice over its triangles", "[contact]") {
    unsigned seed = 20;
    for (const auto& [name, obstacle] : every_obstacle()) {
        const Touching t(obstacle, ++seed);
        CAPTURE(name);
        const Points x = t.x + random_points(t.x.cols(), 0.02, seed);
        const Faces& faces = t.model.cloths[0].mesh.faces;
        const double found = t.contact.least_distance(x, t.time);
        // skipping far triangles loses nothing; what is left is half a cell of the lattice
        CHECK(found == Approx(lattice_distance(faces, x, obstacle, t.time, 2 * t.contact.level() + 2)));
        CHECK(found == Approx(lattice_distance(faces, x, obstacle, t.time, 40)).margin(2e-3));
    }
}

TEST_CASE("contact's stiffness and damping are the derivatives of its force, on every obstacle",
          "[contact]") {
    unsigned seed = 90;
    for (const auto& [name, obstacle] : every_obstacle()) {
        Touching t(obstacle, ++seed);
        CAPTURE(name);
        Couplings couplings;
        t.contact.add_couplings(couplings);
        BlockMatrix k(t.model, couplings), b = k;
        const auto force = [&](In x, In v) {
            Points f = Points::Zero(3, x.cols());
            t.contact.add_all(x, v, t.time, f);
            return f;
        };
        // a cloth that goes with the obstacle feels no damping
        const MovingPose moving = obstacle.motion.at(t.time);
        Points along(3, t.x.cols());
        for (Eigen::Index i = 0; i < t.x.cols(); ++i) along.col(i) = moving.velocity_at(t.x.col(i));
        t.contact.add_stiffness(t.x, along, t.time, k);
        const Eigen::MatrixXd still = minus_jacobian(
            [&](In y) {
                Points f = Points::Zero(3, y.cols());
                t.contact.add_conservative(y, t.time, f);
                return f;
            },
            t.x, 1e-6, t.model);
        CHECK((dense(k, t.x.cols()) - still).norm() < 1e-6 * still.norm());

        t.contact.add_damping(t.x, t.v, t.time, b);
        const Eigen::MatrixXd damped =
            minus_jacobian([&](In w) { return force(t.x, w); }, t.v, 1e-5, t.model);
        CHECK((dense(b, t.x.cols()) - damped).norm() <= 1e-8 * damped.norm());

        // with damping, all but the normals' turning; a plane's does not turn
        if (name.starts_with("plane") && !obstacle.motion.moves()) {
            k.set_zero();
            t.contact.add_stiffness(t.x, t.v, t.time, k);
            const Eigen::MatrixXd both =
                minus_jacobian([&](In y) { return force(y, t.v); }, t.x, 1e-6, t.model);
            CHECK((dense(k, t.x.cols()) - both).norm() < 1e-6 * both.norm());
        }
    }
}

TEST_CASE("no contact is stiffer than its majorant or more damped, on every obstacle but a torus",
          "[contact]") {
    unsigned seed = 120;
    for (const auto& [name, obstacle] : every_obstacle()) {
        if (name.starts_with("torus")) continue;  // hollow inside: its bend is left out
        const Touching t(obstacle, ++seed);
        const MovingPose moving = obstacle.motion.at(t.time);
        Points v = random_points(t.x.cols(), 0.01, seed);  // beside the obstacle's own
        for (Eigen::Index i = 0; i < v.cols(); ++i) v.col(i) += moving.velocity_at(t.x.col(i));
        Couplings couplings;
        t.contact.add_couplings(couplings);
        for (const double c : {1e-3, 0.1}) {
            BlockMatrix matrix(t.model, couplings);
            t.contact.add_stiffness(t.x, v, t.time, matrix);
            matrix.weigh(1 / c, false);
            t.contact.add_damping(t.x, v, t.time, matrix);
            Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(t.x.cols());
            t.contact.add_majorant(t.x, v, t.time, c, diagonal);
            Eigen::MatrixXd rest = -dense(matrix, t.x.cols());
            rest.diagonal() += diagonal.transpose().replicate(3, 1).reshaped();
            const Eigen::VectorXd modes = eigenvalues(rest);
            CAPTURE(name, c);
            CHECK(diagonal.maxCoeff() > 0);
            CHECK(modes.minCoeff() > -1e-12 * diagonal.maxCoeff());
        }
    }
}
