// A membrane of finite elements in motion, under every kind of method.
#include <catch2/catch.hpp>
#include <cmath>

#include "simulate/strain.h"
#include "support/membranes.h"
#include "support/motion.h"
#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

// A sheet hung by two corners.
Setup hung(MembraneKind kind, double damping = 0, int divisions = 6) {
    Fabric fabric = membrane_fabric(kind, 100);
    fabric.damping = damping;
    Setup setup =
        scene_of(jittered_square(divisions, "alternating", 0.2), fabric, {0, divisions * (divisions + 1)});
    return setup;
}

// The most that the energy of a trembling sheet grows to over 3000 steps of Verlet, over what it had.
double growth(MembraneKind kind, double share_of_limit, bool by_bound) {
    const Model model = model_of(jittered_square(5, "alternating", 0.2), membrane_fabric(kind, 100));
    Dynamics dynamics(model, forces_of(model, {Vec3::Zero(), {}}), nullptr);
    const Points& rest = model.cloths[0].mesh.rest;
    const double omega =
        by_bound ? gershgorin_spectrum(dynamics, rest).omega : measured_omega(dynamics, rest);
    const Method& verlet = method_named("verlet");
    const double h = share_of_limit * verlet.longest_step({omega, 0});
    State state{rest, random_points(model.vertices(), 1e-4, 5), 0};
    const auto integrator = verlet.make();
    integrator->begin(dynamics, state, h);
    const double start = dynamics.kinetic_energy(state.v);
    double most = 0;
    for (int i = 0; i < 3000 && most < 1e3 * start; ++i) {
        if (!integrator->step(dynamics, state, h)) return INFINITY;
        most = std::max(most, dynamics.kinetic_energy(state.v) + dynamics.potential_energy(state.x, 0));
    }
    return most / start;
}

}  // namespace

TEST_CASE("Verlet just under a membrane's step bound keeps its energy, beyond the limit it does not",
          "[simulate]") {
    for (const MembraneKind kind : membrane_kinds) {
        CAPTURE(int(kind));
        CHECK(growth(kind, 0.99, true) < 1.5);  // measured 1.13
        CHECK(growth(kind, 1.05, false) > 100);
    }
}

TEST_CASE("a hung membrane keeps its energy while it swings and stretches", "[simulate]") {
    for (const MembraneKind kind : membrane_kinds) {
        for (const char* method : {"verlet", "takahashi_imada", "rk4"}) {
            Setup setup = hung(kind);
            setup.method = method;
            setup.frames = 20;
            Simulation simulation(std::move(setup));
            const double start = simulation.energies().total();
            double fastest = 0;
            while (simulation.frame() < simulation.frames()) {
                const FrameReport report = simulation.advance();
                CAPTURE(int(kind), method, report.trouble);
                REQUIRE(report.trouble.empty());
                CHECK(report.retries == 0);
                fastest = std::max(fastest, report.fastest);
            }
            CAPTURE(int(kind), method, fastest, simulation.energies().total() - start);
            CHECK(fastest > 1);
            // of some 2 J that fall; measured 9e-4
            CHECK(std::abs(simulation.energies().total() - start) < 3e-3);
        }
    }
}

TEST_CASE("every method takes a membrane where the most exact one does", "[simulate]") {
    const auto end_of = [](MembraneKind kind, std::string_view method, double step) {
        Setup setup = hung(kind, 0.1, 4);
        setup.method = method;
        setup.step = step;
        setup.frames = 4;
        Simulation simulation(std::move(setup));
        while (simulation.frame() < simulation.frames()) {
            const FrameReport report = simulation.advance();
            CAPTURE(int(kind), method, report.trouble);
            REQUIRE(report.trouble.empty());
        }
        return simulation.state().x;
    };
    for (const MembraneKind kind : membrane_kinds) {
        const Points exact = end_of(kind, "rk4", 1e-4);
        for (const Method& method : methods()) {
            if (method.conservative_only()) continue;
            const Points x = end_of(kind, method.name, 2e-4);
            const double error = std::sqrt((x - exact).colwise().squaredNorm().mean());
            CAPTURE(int(kind), method.name, error);
            CHECK(error < (method.order == 1 ? 4e-4 : 2e-6));  // measured 1.8e-4 and 4e-7
        }
    }
}

TEST_CASE("a membrane sets xpbd no step: one far too stiff for it stays bounded", "[simulate]") {
    for (const MembraneKind kind : membrane_kinds) {
        Setup setup = scene_of(square(16), membrane_fabric(kind, 5e5), {0, 16 * 17});
        setup.method = "xpbd";
        setup.step = 1 / 300.0;
        setup.frames = 20;
        Simulation simulation(setup);
        CHECK(simulation.longest_step() == INFINITY);
        const double fastest = run(simulation);
        CAPTURE(int(kind), fastest);
        CHECK(fastest < 15);
    }
}

TEST_CASE("a membrane comes to rest where its forces balance, by every implicit method alike", "[simulate]") {
    for (const MembraneKind kind : membrane_kinds) {
        Points first;
        for (const char* method : {"backward_euler", "bdf2", "tr_bdf2", "projective_dynamics"}) {
            Setup setup = hung(kind, 0, 4);
            setup.method = method;
            setup.world.air.drag = 1;  // or it would rock on for long
            setup.step = 0.05;
            setup.frame_rate = 1;
            setup.frames = 60;
            Simulation simulation(std::move(setup));
            while (simulation.frame() < simulation.frames()) {
                const FrameReport report = simulation.advance();
                CAPTURE(int(kind), method, report.trouble);
                REQUIRE(report.trouble.empty());
            }
            const State& state = simulation.state();
            Points a(3, state.x.cols());
            simulation.dynamics().acceleration(state.x, state.v, state.time, a);
            CAPTURE(int(kind), method);
            CHECK(a.colwise().norm().maxCoeff() < 1e-3);  // of 9.81
            if (first.cols() == 0) first = state.x;
            CHECK((state.x - first).colwise().norm().maxCoeff() < 1e-4);
        }
    }
}

TEST_CASE("an irregular membrane between pins that an even strain has moved rests in that strain",
          "[simulate]") {
    const Mesh mesh = square(6, "pseudo_random");
    const Mat3 strain{{1.1, 0, 0.1}, {0, 1, 0}, {0, 0, 1.05}};
    for (const MembraneKind kind : membrane_kinds) {
        Model model = model_of(mesh, membrane_fabric(kind, 100));
        const Points moved = strain * mesh.rest;
        std::vector<int> border;
        State state{moved, Points::Zero(3, mesh.vertices()), 0};
        for (int v = 0; v < mesh.vertices(); ++v) {
            if (std::max(std::abs(mesh.rest(0, v)), std::abs(mesh.rest(2, v))) > 0.5 - 1e-9)
                border.push_back(v);
            else
                state.x.col(v) += 0.01 * random_points(1, 1, static_cast<unsigned>(v)).col(0);
        }
        hold(model, border, moved);
        Dynamics dynamics(model, forces_of(model, {Vec3::Zero(), {}}), nullptr);
        const State end = integrated(method_named("backward_euler"), dynamics, state, 1000, 20);
        CAPTURE(int(kind), (end.x - moved).norm());
        CHECK((state.x - moved).norm() > 0.01);
        CHECK((end.x - moved).norm() < 1e-9);
    }
}

TEST_CASE("a membrane's strain picture shows the strain of its edges, as that of springs does",
          "[simulate]") {
    const Cloth cloth = make_cloth(square(3), membrane_fabric(MembraneKind::stvk, 100));
    const Points x = Vec3(1.1, 1, 1.1).asDiagonal() * cloth.mesh.rest;
    CHECK((vertex_strain(cloth, x).array() - 0.1f).abs().maxCoeff() < 1e-6f);
}
