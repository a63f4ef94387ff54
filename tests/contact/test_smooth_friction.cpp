#include "contact/smooth_friction.h"

#include <catch2/catch.hpp>

#include "support/matrices.h"
#include "support/touching.h"

using namespace drape;
using namespace drape::test;

namespace {

// A sheet pressed on a sliding plane, its vertices at some speed relative to it.
struct Pressed {
    Model model = model_of(raised(square(3), 0.05), Touching::fabric());
    State state{model.cloths[0].mesh.rest, Points::Zero(3, 16), 0.5};
    Contact contact;
    SmoothFriction friction;
    Points pressing = Points::Zero(3, 16);  // all contact force but friction [N]

    explicit Pressed(double speed)
        : contact(model, {obstacle_of("plane", {}, 0.4, carry(0, 1, {0.3, 0, 0}))}, Vec3(0, -9.81, 0), state,
                  1) {
        state.v = random_points(16, speed, 3);
        state.v.row(1).setZero();
        state.v.row(0).array() += 0.45;  // the plane's speed halfway
        contact.prepare(state, 1e-3);
        contact.add_all(state.x, state.v, state.time, pressing);
        friction.hold(contact);
    }
    Points force(In v) const {
        Points f = Points::Zero(3, 16);
        friction.add_force(v, f);
        return f;
    }
};

}  // namespace

TEST_CASE(
    "smooth friction is minus the gradient of its potential, and its matrix the slope, sticking or sliding",
    "[contact]") {
    for (const double speed : {1e-5, 1e-4, 1e-2}) {
        const Pressed t(speed);
        CAPTURE(speed);
        REQUIRE(t.friction.holds_any());
        const Points f = t.force(t.state.v);
        const Points expected =
            minus_gradient([&](In v) { return t.friction.potential(v); }, t.state.v, 1e-3 * speed);
        CHECK((f - expected).norm() < 1e-6 * f.norm());

        Couplings couplings;
        t.contact.add_couplings(couplings);
        BlockMatrix b(t.model, couplings);
        t.friction.add_damping(t.state.v, b);
        const Eigen::MatrixXd slope =
            minus_jacobian([&](In v) { return t.force(v); }, t.state.v, 1e-4 * speed, t.model);
        CHECK((dense(b, 16) - slope).norm() < 1e-6 * slope.norm());
    }
}

TEST_CASE("smooth friction holds mu N once a point slides, and books what it takes", "[contact]") {
    Pressed t(1);
    Points f = Points::Zero(3, 16);
    const ContactWork power = t.friction.add_force(t.state.v, f);
    for (Eigen::Index i = 0; i < 16; ++i) CHECK(f.col(i).norm() == Approx(0.4 * t.pressing(1, i)));
    CHECK(power.dissipated > 0);
    CHECK(power.driven - power.dissipated == Approx(f.cwiseProduct(t.state.v).sum()));
}

TEST_CASE("smooth friction's potential lies below the parabola of its majorant, at every velocity",
          "[contact]") {
    for (const double speed : {1e-5, 1e-4, 1e-2}) {
        const Pressed t(speed);
        constexpr double c = 0.01;
        Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(16);
        t.friction.add_majorant(t.state.v, c, diagonal);
        for (const double change : {1e-6, 1e-4, 1e-2, 1.0}) {
            const Points u = random_points(16, change, 5);
            const double slope = -t.force(t.state.v).cwiseProduct(u).sum();
            const double bend = c * diagonal.dot(u.colwise().squaredNorm());
            CAPTURE(speed, change);
            CHECK(t.friction.potential(t.state.v + u) <=
                  t.friction.potential(t.state.v) + slope + bend / 2 * (1 + 1e-9));
        }
    }
}
