// Properties every force in the table has, whatever it is: a new row is held to them by being listed.
#include <catch2/catch.hpp>

#include "support/every_force.h"
#include "support/gradient.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("every force is minus the gradient of its energy, on every fabric", "[force]") {
    for (const Fabric& fabric : every_fabric()) {
        const Cloth cloth = make_cloth(jittered_square(4, "alternating", 0.2), fabric);
        const Points x = cloth.mesh.rest + random_points(cloth.vertices(), 0.06, 3);
        for (const Case& c : every_force(cloth)) {
            CAPTURE(c.name, int(fabric.stretch_model), int(fabric.altitude), int(fabric.bending_kind));
            Points f = Points::Zero(3, x.cols());
            c.force->add_conservative(x, f);
            const Points expected = minus_gradient([&](In y) { return c.force->energy(y); }, x, 1e-5);
            // measured: below 3e-9 of the largest force
            CHECK((f - expected).norm() <= 1e-7 * (1e-3 + expected.norm()));
        }
    }
}

TEST_CASE("internal forces, damping included, push nothing as a whole and turn nothing", "[force]") {
    for (const Fabric& fabric : every_fabric()) {
        const Cloth cloth = make_cloth(jittered_square(4, "one_way", 0.2), fabric);
        const Points x = cloth.mesh.rest + random_points(cloth.vertices(), 0.06, 4);
        const Points v = random_points(cloth.vertices(), 1, 5);
        for (const Case& c : every_force(cloth)) {
            if (!c.internal) continue;
            CAPTURE(c.name, int(fabric.altitude), int(fabric.bending_kind));
            Points still = Points::Zero(3, x.cols()), f = still;
            c.force->add_conservative(x, still);
            c.force->add_all(x, v, 0, f);
            CHECK(net_force(f).norm() <= 1e-12 * f.norm());
            CHECK(net_torque(x, still).norm() <= 1e-12 * still.norm());
            // a plate's damping, linear in the velocities, takes the turning of a bent sheet for bending
            const bool plate = c.name == "bending" && fabric.bending_kind == BendingKind::plate;
            if (!plate) CHECK(net_torque(x, f).norm() <= 1e-12 * f.norm());
        }
    }
}

TEST_CASE("damping only takes energy, and as much as its force says", "[force]") {
    for (const Fabric& fabric : every_fabric()) {
        const Cloth cloth = make_cloth(jittered_square(4, "alternating", 0.2), fabric);
        const Points x = cloth.mesh.rest + random_points(cloth.vertices(), 0.06, 6);
        const Points v = random_points(cloth.vertices(), 1, 7);
        for (const Case& c : every_force(cloth)) {
            CAPTURE(c.name, int(fabric.altitude), int(fabric.bending_kind));
            Points conservative = Points::Zero(3, x.cols()), all = Points::Zero(3, x.cols());
            c.force->add_conservative(x, conservative);
            const Power power = c.force->add_all(x, v, 0.3, all);
            CHECK(power.dissipated >= 0);
            const double by_force = (all - conservative).cwiseProduct(v).sum();
            CHECK(power.driven - power.dissipated == Approx(by_force).epsilon(1e-9).margin(1e-12));
        }
    }
}

TEST_CASE("the step bound is never below the stiffness that finite differences find", "[force]") {
    for (const Fabric& fabric : every_fabric()) {
        const Cloth cloth = make_cloth(square(4), fabric);
        const Points x = cloth.mesh.rest + random_points(cloth.vertices(), 0.002, 8);
        for (const Case& c : every_force(cloth)) {
            CAPTURE(c.name, int(fabric.stretch_model), int(fabric.altitude), int(fabric.bending_kind));
            StepBound bound(cloth.vertices());
            c.force->add_bound(x, bound);
            // power iteration for the largest |eigenvalue| of the stiffness
            Points direction = random_points(x.cols(), 1, 9);
            double largest = 0;
            for (int i = 0; i < 60; ++i) {
                direction /= direction.norm();
                Points plus = Points::Zero(3, x.cols()), minus = plus;
                c.force->add_conservative(x + 1e-6 * direction, plus);
                c.force->add_conservative(x - 1e-6 * direction, minus);
                direction = (minus - plus) / 2e-6;
                largest = direction.norm();
                if (largest == 0) break;
            }
            CHECK(bound.stiffness.maxCoeff() >= 0.999 * largest);
        }
    }
}

TEST_CASE("a force on a model's second cloth acts on its columns alone, as it would on a first one",
          "[force]") {
    const int before = 7;
    for (const Fabric& fabric : every_fabric()) {
        Cloth first = make_cloth(jittered_square(3, "one_way", 0.2), fabric), second = first;
        second.first = before;
        const int both = before + first.vertices();
        const Points x = random_points(both, 1, 10), v = random_points(both, 1, 11);
        const Points own = x.rightCols(first.vertices()), own_v = v.rightCols(first.vertices());
        const std::vector<Case> alone = every_force(first), beside = every_force(second);
        for (size_t i = 0; i < alone.size(); ++i) {
            CAPTURE(alone[i].name, int(fabric.altitude), int(fabric.bending_kind));
            Points expected = Points::Zero(3, first.vertices()), f = Points::Zero(3, both);
            alone[i].force->add_all(own, own_v, 0.3, expected);
            beside[i].force->add_all(x, v, 0.3, f);
            CHECK(f.leftCols(before).isZero(0));
            CHECK(f.rightCols(first.vertices()) == expected);
            CHECK(beside[i].force->energy(x) == alone[i].force->energy(own));
            StepBound bound(first.vertices()), wide(both);
            alone[i].force->add_bound(own, bound);
            beside[i].force->add_bound(x, wide);
            CHECK(wide.stiffness.head(before).isZero(0));
            CHECK(wide.stiffness.tail(first.vertices()) == bound.stiffness);
            CHECK(wide.damping.tail(first.vertices()) == bound.damping);
        }
    }
}

TEST_CASE("no sheet, however crushed, is met with a force that is not a number", "[force]") {
    for (const Fabric& fabric : every_fabric()) {
        const Cloth cloth = make_cloth(square(3), fabric);
        const Points& rest = cloth.mesh.rest;
        Points line = rest, edge = rest, point = rest;
        line.row(0).setZero();
        edge.col(5) = edge.col(6);
        point.setConstant(0.3);
        for (const Points& x : {line, edge, point}) {
            for (const Case& c : every_force(cloth)) {
                CAPTURE(c.name, int(fabric.altitude), int(fabric.bending_kind));
                Points f = Points::Zero(3, x.cols());
                const Power power = c.force->add_all(x, random_points(x.cols(), 1, 12), 0.3, f);
                CHECK(f.allFinite());
                CHECK(std::isfinite(power.dissipated + power.driven + c.force->energy(x)));
                StepBound bound(cloth.vertices());
                c.force->add_bound(x, bound);
                CHECK((bound.stiffness + bound.damping).allFinite());
            }
        }
    }
}
