#include <catch2/catch.hpp>

#include "base/rigid_motion.h"
#include "support/touching.h"

using namespace drape;
using namespace drape::test;

namespace {

// The kinetic energy of friction's impulses of a time h, what was booked for it, and what it changed.
struct Rubbed {
    ContactWork work;
    double gained = 0;
    Points before;

    Rubbed(Touching& t, double h) : before(t.v) {
        Points f = Points::Zero(3, t.x.cols());
        t.contact.add_all(t.x, t.v, t.time, f);
        const double energy = t.kinetic_energy();
        work = t.contact.rub(t.v, t.model, h);
        gained = t.kinetic_energy() - energy;
    }
};

}  // namespace

TEST_CASE("friction slows each vertex by mu N h / m against its sliding and never turns it round",
          "[contact]") {
    for (const double h : {1e-5, 1e-3, 1e-1}) {
        Touching t(obstacle_of("plane", {}, 0.3), 6, 0.1);
        Points f = Points::Zero(3, t.x.cols());
        t.contact.add_all(t.x, t.v, t.time, f);
        const Rubbed rubbed(t, h);
        CAPTURE(h);
        for (Eigen::Index i = 0; i < t.x.cols(); ++i) {
            const Vec3 before = rubbed.before.col(i), after = t.v.col(i);
            CHECK(after.y() == before.y());
            const Vec3 slid(before.x(), 0, before.z()), slides(after.x(), 0, after.z());
            const double slowed = std::min(0.3 * f(1, i) * h * t.model.inverse_mass[i], slid.norm());
            CHECK((slides - (1 - slowed / slid.norm()) * slid).norm() < 1e-15);
        }
        CHECK(rubbed.work.dissipated == Approx(-rubbed.gained));
        if (h == 0.1) CHECK(t.v.row(0).cwiseAbs().maxCoeff() < 1e-16);
    }
}

TEST_CASE("friction's heat and the obstacle's work are what the cloth's kinetic energy changed by",
          "[contact]") {
    unsigned seed = 30;
    int rubs = 0, all = 0;
    for (const auto& [name, obstacle] : every_obstacle(0.5)) {
        for (const double h : {1e-5, 1e-2}) {
            Touching t(obstacle, ++seed);
            CAPTURE(name, h);
            const Rubbed rubbed(t, h);
            CHECK(rubbed.work.dissipated >= 0);
            CHECK(rubbed.gained ==
                  Approx(rubbed.work.driven - rubbed.work.dissipated).margin(1e-14 * t.kinetic_energy()));
            rubs += rubbed.work.dissipated > 0;
            if (!obstacle.motion.moves()) CHECK(rubbed.work.driven == 0);
            ++all;
        }
    }
    CHECK(rubs > 0.8 * all);  // a few obstacles leave the cloth too fast to press on it
}

TEST_CASE("strong friction carries a cloth along with a moving plane", "[contact]") {
    const RigidMotion slide({{0, Vec3(0, 0, 0)}, {1, Vec3(2, 0, 1)}});
    Touching t(obstacle_of("plane", {}, 1e3, slide), 7, 0.1);
    const Rubbed rubbed(t, 1);
    const Vec3 plane = slide.at(t.time).linear;
    for (Eigen::Index i = 0; i < t.x.cols(); ++i) {
        CHECK(t.v(0, i) == Approx(plane.x()));
        CHECK(t.v(2, i) == Approx(plane.z()));
    }
    CHECK(rubbed.work.driven > 0);
}

TEST_CASE("an obstacle without friction rubs nothing", "[contact]") {
    Touching t(obstacle_of("plane", {}, 0), 8);
    const Rubbed rubbed(t, 1);
    CHECK(t.v == rubbed.before);
    CHECK(rubbed.work.dissipated == 0);
}
