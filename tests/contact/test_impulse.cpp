#include "contact/impulse.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "support/touching.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("damping's impulse is its own implicit step, and no contact pulls", "[contact]") {
    const Vec3 up(0, 1, 0);
    constexpr double w = 3, damping = 0.7, pressed = 0.1;
    for (const double speed : {-2.0, 0.01}) {
        const Vec3 impulse = contact_impulse({up, pressed, damping, 0}, speed * up, w);
        const double after = speed + w * impulse.y();
        CHECK(after == Approx(speed / (1 + damping * w)));
        CHECK(impulse.y() == Approx(-damping * after));
    }
    CHECK(contact_impulse({up, pressed, damping, 0}, 2 * up, w).y() == -pressed);
}

TEST_CASE("friction holds by all that presses, damping's part too", "[contact]") {
    const Vec3 up(0, 1, 0), falls(5, -2, 0);
    constexpr double w = 3, damping = 0.7, pressed = 0.1, friction = 0.2;
    const Vec3 impulse = contact_impulse({up, pressed, damping, friction}, falls, w);
    CHECK(impulse.x() == Approx(-friction * (pressed + impulse.y())));
    const Vec3 leaves(5, 2, 0);
    CHECK(contact_impulse({up, pressed, damping, friction}, leaves, w).x() == 0);
    const Vec3 slow(1e-3, -2, 0);
    CHECK(slow.x() + w * contact_impulse({up, pressed, damping, friction}, slow, w).x() ==
          Approx(0).margin(1e-18));
}

TEST_CASE("a contact's impulse only takes energy, however long the time", "[contact]") {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> one(-1, 1);
    for (int i = 0; i < 200; ++i) {
        const Vec3 normal = Vec3(one(random), one(random), one(random)).normalized();
        const Vec3 relative(one(random), one(random), one(random));
        const double w = std::exp(5 * one(random)), pressed = std::exp(9 * one(random));
        const Vec3 impulse = contact_impulse({normal, pressed, std::exp(20 * one(random)), 0.5}, relative, w);
        CAPTURE(i);
        CHECK(impulse.dot(relative + w / 2 * impulse) <= 1e-15);
        CHECK((relative + w * impulse).norm() <= relative.norm() * (1 + 1e-12));
        CHECK(impulse.dot(normal) >= -pressed * (1 + 1e-12));
    }
}

TEST_CASE("methods that kick take damping with friction and its heat is booked", "[contact]") {
    unsigned seed = 50;
    for (const auto& [name, obstacle] : every_obstacle(0.5)) {
        for (const double h : {1e-6, 1e-2}) {
            Touching t(obstacle, ++seed);
            CAPTURE(name, h);
            Points f = Points::Zero(3, t.x.cols()), barrier = f;
            const ObstacleContact::Result result =
                t.contact.add_all(t.x, t.v, t.time, f, NormalDamping::impulse);
            t.contact.add_conservative(t.x, t.time, barrier);
            CHECK(f == barrier);
            CHECK(result.dissipated == 0);
            CHECK(result.limits.gamma == 0);
            const double before = t.kinetic_energy();
            const ContactWork work = t.contact.rub(t.v, t.model, h);
            CHECK(work.dissipated > 0);
            CHECK(t.kinetic_energy() - before ==
                  Approx(work.driven - work.dissipated).margin(1e-13 * before));
        }
    }
}

TEST_CASE("in a short time impulses are what damping's force gives", "[contact]") {
    for (const auto& [name, obstacle] : every_obstacle()) {
        Touching forced(obstacle, 77), kicked(obstacle, 77);
        CAPTURE(name);
        constexpr double h = 1e-8;
        Points all = Points::Zero(3, forced.x.cols()), barrier = all;
        forced.contact.add_all(forced.x, forced.v, forced.time, all);
        kicked.contact.add_all(kicked.x, kicked.v, kicked.time, barrier, NormalDamping::impulse);
        const Points before = kicked.v;
        kicked.contact.rub(kicked.v, kicked.model, h);
        const Points damping = (kicked.v - before) * kicked.model.mass.asDiagonal() / h;
        CHECK((barrier + damping - all).norm() < 1e-4 * all.norm());
    }
}

TEST_CASE("impulses book what pins take that move", "[contact]") {
    unsigned seed = 60;
    int mixed = 0;  // obstacles where a point hangs on pinned and free vertices
    for (const auto& [name, obstacle] : every_obstacle(0.5)) {
        Touching t(obstacle, ++seed);
        for (const int pinned : {0, 5, 10}) t.model.inverse_mass[pinned] = 0;
        t.contact = ObstacleContact(t.model, t.model.cloths[0], obstacle, Vec3(0, -9.81, 0), 1);
        t.contact.gather(t.x, t.time, 1);
        CAPTURE(name);
        Points f = Points::Zero(3, t.x.cols());
        t.contact.add_all(t.x, t.v, t.time, f, NormalDamping::impulse);
        const auto free_energy = [&] {
            double energy = 0;
            for (int i = 0; i < t.v.cols(); ++i)
                if (t.model.inverse_mass[i] > 0) energy += t.model.mass[i] * t.v.col(i).squaredNorm() / 2;
            return energy;
        };
        const Points before = t.v;
        const double energy = free_energy();
        const ContactWork work = t.contact.rub(t.v, t.model, 1e-3);
        CHECK(free_energy() - energy == Approx(work.driven - work.dissipated).margin(1e-13 * energy));
        CHECK(t.v.col(5) == before.col(5));
        mixed += t.contact.level() > 1 && !obstacle.motion.moves() && work.driven != 0;
    }
    CHECK(mixed > 0);
}
