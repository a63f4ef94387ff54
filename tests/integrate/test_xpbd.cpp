#include <catch2/catch.hpp>

#include "support/motion.h"
#include "support/setups.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("of a lone linear spring xpbd is implicit Euler, damping included, at any step", "[integrate]") {
    for (const Spectrum& mode : {Spectrum{3, 0}, Spectrum{3, 0.7}, Spectrum{1000, 0.1}}) {
        for (const double h : {0.01, 0.3, 10.0}) {
            Oscillator spring(mode);
            State state = Oscillator::at({1, 0, 0}, {0.5, 0, 0});
            const auto integrator = method_named("xpbd").make();
            integrator->begin(spring.dynamics(), state, h);
            double x = 1, v = 0.5;
            for (int i = 0; i < 20; ++i) {
                REQUIRE(integrator->step(spring.dynamics(), state, h));
                const double next =
                    (x + h * v + h * mode.gamma * x) / (1 + h * h * mode.omega * mode.omega + h * mode.gamma);
                v = (next - x) / h;
                x = next;
                CAPTURE(mode.omega, mode.gamma, h, i);
                CHECK(state.x(0, 1) == Approx(x).margin(1e-12));
                CHECK(state.v(0, 1) == Approx(v).margin(1e-10));
            }
        }
    }
}

TEST_CASE("springs set xpbd no step: cloth far too stiff for it stays bounded", "[integrate]") {
    for (const char* pattern : {"alternating", "one_way"}) {
        Setup setup = scene_of(square(24, pattern), bare_springs(5e5), {0, 24 * 25});
        setup.method = "xpbd";
        setup.step = 1 / 300.0;
        setup.frames = 40;
        Simulation simulation(setup);
        CHECK(simulation.longest_step() == INFINITY);
        const double fastest = run(simulation);
        CAPTURE(pattern, fastest);
        CHECK(fastest < 15);  // measured 11; a free fall of as long reaches 20 m/s
    }
}

TEST_CASE("bending, drag and contact bind the step of xpbd, springs do not", "[integrate]") {
    Setup soft = ball_drop(6), stiff = ball_drop(6);
    stiff.model = model_of(square(6), [] {
        Fabric fabric = full_fabric();
        fabric.stretch = 1e6;
        return fabric;
    }());
    for (Setup* setup : {&soft, &stiff}) setup->method = "xpbd";
    Simulation one(soft), other(stiff);
    CHECK(std::isfinite(one.longest_step()));
    CHECK(other.longest_step() > 0.5 * one.longest_step());
    CHECK(one.step() <= 0.0005);
}
