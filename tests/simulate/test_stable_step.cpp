#include "simulate/stable_step.h"

#include <catch2/catch.hpp>

#include "support/matrices.h"
#include "support/motion.h"
#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

// Of M^-1 K, for a matrix with a row per coordinate that is zero where pinned.
double largest_eigenvalue(const Model& model, const Eigen::MatrixXd& k) {
    const Eigen::VectorXd root = model.mass.cwiseSqrt().cwiseInverse();
    const Eigen::VectorXd scale = root.transpose().replicate(3, 1).reshaped();
    return eigenvalues(scale.asDiagonal() * k * scale.asDiagonal()).maxCoeff();
}

double true_omega(Dynamics& dynamics, const Points& x) {
    const auto force = [&](In y) -> Points {
        Points f;
        dynamics.acceleration_without_contact(y, f);
        return f * dynamics.model().mass.asDiagonal();
    };
    return std::sqrt(largest_eigenvalue(dynamics.model(), minus_jacobian(force, x, 1e-6, dynamics.model())));
}

// By the matrix that implicit methods take.
double true_gamma(const Dynamics& dynamics, const Points& x) {
    BlockMatrix b(dynamics.model(), dynamics.couplings());
    for (const ActiveForce& active : dynamics.forces())
        active.force->add_damping(x, Points::Zero(3, x.cols()), 0, b);
    return largest_eigenvalue(dynamics.model(), dense(b, x.cols()));
}

}  // namespace

TEST_CASE("a triangle's fastest mode is the one on paper", "[simulate]") {
    // two springs at 60 degrees hold the apex: c (1 + cos 60) / m
    Model model = model_of(equilateral_triangle(), bare_springs(500));
    const Points x = model.cloths[0].mesh.rest;
    hold(model, {0, 1}, x);
    Dynamics dynamics(model, forces_of(model, {}), nullptr);
    CHECK(measured_omega(dynamics, x) == Approx(std::sqrt(1.5 * 500 / model.mass[2])).epsilon(1e-6));
}

TEST_CASE("the measured fastest mode is just below the true one, Gershgorin's bound above", "[simulate]") {
    Setup bent = scene_of(jittered_square(6, "alternating", 0.3), full_fabric(), {0, 6});
    for (const Setup& setup : {swatch(6, 200), flag(6), ball_drop(6), bent}) {
        Simulation simulation(setup);
        for (int frame = 0; frame <= 6; frame += 3) {
            const Points& x = simulation.state().x;
            const double truth = true_omega(simulation.dynamics(), x);
            const double measured = measured_omega(simulation.dynamics(), x);
            CAPTURE(frame, truth);
            CHECK(measured > 0.98 * truth);  // measured 0.993
            CHECK(measured < 1.0001 * truth);
            CHECK(gershgorin_spectrum(simulation.dynamics(), x).omega > truth);
            for (int i = 0; i < 3; ++i) REQUIRE(simulation.advance().trouble.empty());
        }
    }
}

TEST_CASE("the measured strongest damping is just below the true one and far below Gershgorin's bound",
          "[simulate]") {
    Setup bent = scene_of(jittered_square(6, "alternating", 0.3), full_fabric(), {0, 6});
    Setup dragged = ball_drop(6);
    dragged.world.air.drag = 1.5;
    for (const Setup& setup : {bent, dragged}) {
        Simulation simulation(setup);
        for (int frame = 0; frame <= 6; frame += 3) {
            const Points& x = simulation.state().x;
            const double truth = true_gamma(simulation.dynamics(), x);
            const double measured = measured_gamma(simulation.dynamics(), x);
            CAPTURE(frame, truth);
            CHECK(truth > 0);
            CHECK(measured > 0.98 * truth);
            CHECK(measured < 1.0001 * truth);
            CHECK(gershgorin_spectrum(simulation.dynamics(), x).gamma > 1.5 * truth);
            for (int i = 0; i < 3; ++i) REQUIRE(simulation.advance().trouble.empty());
        }
    }
}

TEST_CASE("damping that is not linear keeps its bound beside what is measured", "[simulate]") {
    Setup still = flag(6), windy = flag(6);
    still.world.air.aerodynamic = false;
    Simulation without(still), with(windy);
    const Points& x = with.state().x;
    const double wind =
        with.dynamics().nonlinear_bound(x).damping.cwiseProduct(with.model().inverse_mass).maxCoeff();
    CHECK(wind > 0);
    CHECK(measured_gamma(with.dynamics(), x) == measured_gamma(without.dynamics(), x) + wind);
    CHECK(measured_gamma(with.dynamics(), x) > true_gamma(with.dynamics(), x));
}

TEST_CASE("measuring the fastest mode depends on nothing but the pose", "[simulate]") {
    Simulation moved(ball_drop()), fresh(ball_drop());
    run(moved);
    const Points x = moved.state().x;
    CHECK(measured_omega(moved.dynamics(), x) == measured_omega(fresh.dynamics(), x));
}

TEST_CASE("the step is safe by the measured mode and longer than the bound alone would allow", "[simulate]") {
    for (const Setup& setup : {swatch(8, 200), flag()}) {
        Simulation simulation(setup);
        const double truth = true_omega(simulation.dynamics(), simulation.state().x);
        const Spectrum bound = gershgorin_spectrum(simulation.dynamics(), simulation.state().x);
        CHECK(simulation.guaranteed_step() == simulation.method().longest_step(bound));
        CHECK(simulation.longest_step() > simulation.guaranteed_step());
        const double damped = measured_gamma(simulation.dynamics(), simulation.state().x);
        CHECK(simulation.longest_step() < simulation.method().longest_step({truth, damped}));
    }
}

TEST_CASE("steps are shorter where cloth flies faster than wind was foreseen to be", "[simulate]") {
    Setup setup = scene_of(square(4), bare_springs(20));
    setup.world.air.aerodynamic = true;
    setup.start.v.row(1).setConstant(2000);
    Simulation simulation(std::move(setup));
    const double start = simulation.energies().total();
    const FrameReport report = simulation.advance();
    CHECK(report.trouble == "");
    CHECK(report.retries == 0);
    CHECK(report.steps > report.planned_steps);
    const Energies end = simulation.energies();
    const double drift = end.total() - start - simulation.flow().driven + simulation.flow().dissipated;
    CHECK(std::abs(drift) < 0.05 * start);
    CHECK(simulation.state().v.row(1).maxCoeff() < 60);
}

TEST_CASE("contact's stiffness and damping are added to the cloth's own", "[simulate]") {
    const Spectrum sum = with_contact({3, 1}, {.omega_squared = 16, .gamma = 0.5});
    CHECK(sum.omega == Approx(5));
    CHECK(sum.gamma == Approx(1.5));
}

TEST_CASE("cloth without stiffness has no fastest mode, and its frame is one step", "[simulate]") {
    Setup setup = scene_of(square(2), bare_springs(0));
    Simulation simulation(setup);
    CHECK(measured_omega(simulation.dynamics(), setup.start.x) == 0);
    const FrameReport report = simulation.advance();
    CHECK(report.steps == 1);
    // free fall, exact in one step
    CHECK((simulation.state().x.row(1).array() + 9.81 * 0.05 * 0.05 / 2).abs().maxCoeff() < 1e-15);
}
