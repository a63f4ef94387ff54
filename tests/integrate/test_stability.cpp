// longest_step of every method, on linear oscillators: the limit is safe, and where it claims to be sharp it
// is.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "support/motion.h"

using namespace drape;
using namespace drape::test;

namespace {

// The farthest that `steps` steps of h take an oscillator that starts at 1; stops once all bounds are left.
double farthest(const Method& method, const Spectrum& mode, double h, int steps) {
    Oscillator oscillator(mode);
    State state = Oscillator::at({1, 0, 0}, {0.3, 0, 0});
    const auto integrator = method.make();
    integrator->begin(oscillator.dynamics(), state, h);
    double most = 0;
    for (int i = 0; i < steps && most < 1e6; ++i) {
        REQUIRE(integrator->step(oscillator.dynamics(), state, h));
        most = std::max(most, std::abs(state.x(0, 1)));
    }
    return most;
}

}  // namespace

TEST_CASE("without damping every method is stable just below its longest step and unstable just above",
          "[integrate]") {
    const Spectrum fastest{3.7, 0};
    for (const Method& method : methods()) {
        if (method.is_implicit() || method.projects_springs) continue;
        CAPTURE(method.name);
        const double h = method.longest_step(fastest);
        CHECK(farthest(method, fastest, 0.999 * h, 20000) < 40);  // measured 21
        // where the limit begins a narrow band, it is one of these that grows
        double most = 0;
        for (const double beyond : {1.0001, 1.0003, 1.001})
            most = std::max(most, farthest(method, fastest, beyond * h, 100000));
        if (method.controls_step)
            CHECK(most < 40);
        else
            CHECK(most >= 1e6);
    }
}

TEST_CASE("every mode within the spectrum is stable at the longest step, however damped", "[integrate]") {
    constexpr double omega = 3.7;
    for (const Method& method : methods()) {
        if (method.conservative_only()) continue;
        for (const double ratio : {0.003, 0.03, 0.1, 0.3, 1.0, 3.0, 30.0}) {
            const Spectrum spectrum{omega, 2 * ratio * omega};
            const bool any_step = method.is_implicit() || method.projects_springs;
            const double h = any_step ? 1 / omega : method.longest_step(spectrum);
            for (const double slower : {0.01, 0.3, 0.6, 0.8, 1.0}) {
                for (const double less : {0.0, 0.1, 0.5, 1.0}) {
                    CAPTURE(method.name, ratio, slower, less);
                    const Spectrum mode{slower * omega, less * spectrum.gamma};
                    // slow modes travel v / omega, 8 here; measured 21 beside an undamped limit
                    CHECK(farthest(method, mode, 0.999 * h, 3000) < 40);
                }
            }
        }
    }
}

TEST_CASE("with damping the limits of Verlet and of symplectic Euler are sharp", "[integrate]") {
    for (const char* name : {"verlet", "symplectic_euler"}) {
        for (const double ratio : {0.01, 0.1, 1.0, 10.0}) {
            const Spectrum mode{3.7, 2 * ratio * 3.7};
            const Method& method = method_named(name);
            CAPTURE(name, ratio);
            CHECK(farthest(method, mode, 1.005 * method.longest_step(mode), 20000) >= 1e6);
        }
    }
}

TEST_CASE("every symplectic method keeps the energy of an undamped spring over 1000 periods", "[integrate]") {
    constexpr double omega = 5, rest_length = 1;
    struct Bound {
        std::string_view method;
        double most;
    };
    // measured at 20 steps a period: 0.092, 0.012, 1.1e-4, 6.5e-8, 1.05e-10
    for (const Bound& bound :
         {Bound{"symplectic_euler", 0.12}, Bound{"verlet", 0.015}, Bound{"takahashi_imada", 1.5e-4},
          Bound{"srkn4", 1e-7}, Bound{"srkn6", 1.5e-10}}) {
        Oscillator spring({omega, 0}, rest_length);
        State state = Oscillator::at({1.2, 0, 0}, {0.1, 0.8, 0});  // swings round and lengthens
        const double start = spring.energy(state), h = 2 * std::numbers::pi / omega / 20;
        const auto integrator = method_named(bound.method).make();
        integrator->begin(spring.dynamics(), state, h);
        double early = 0, late = 0;
        for (int i = 1; i <= 20000; ++i) {
            REQUIRE(integrator->step(spring.dynamics(), state, h));
            State out = state;
            integrator->end(spring.dynamics(), out, h);
            const double error = std::abs(spring.energy(out) / start - 1);
            if (i <= 2000) early = std::max(early, error);
            if (i > 18000) late = std::max(late, error);
        }
        CAPTURE(bound.method);
        CHECK(early < bound.most);
        CHECK(late < 1.01 * early);  // no growth: measured 1.0000
    }
}
