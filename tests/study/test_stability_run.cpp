// Known cases land in the right state.
#include "study/stability_run.h"

#include <catch2/catch.hpp>

#include "study/stability_cloth.h"

using namespace drape;

namespace {

constexpr double stiffness = 1000;  // [N/m]
constexpr Trial few{.runs = 3, .steps = 80, .auto_frames = 3};

Setup built_in(size_t cloth, double spring_constant = stiffness) {
    return with_spring_constant(built_in_cloths()[cloth].setup, spring_constant);
}

Verdict judged(const Setup& setup, std::string_view name, double step) {
    return judge_method(setup, method_named(name), step, small_motion(setup).all.omega, few);
}

}  // namespace

TEST_CASE("explicit methods hold just below their theoretical limit and not just above", "[study]") {
    const Setup setup = built_in(0);
    const SmallMotion motion = small_motion(setup);
    for (const std::string name : {"symplectic_euler", "verlet", "takahashi_imada", "rk4"}) {
        const double limit = motion.limit(method_named(name));
        CAPTURE(name, limit);
        CHECK(holds(judged(setup, name, 0.9 * limit).state));
        CHECK_FALSE(holds(judged(setup, name, 1.1 * limit).state));
        CHECK(judged(setup, name, 0.2 * limit).state == Stability::stable);
        CHECK(judged(setup, name, 100 * limit).state >= Stability::unbounded);
    }
}

TEST_CASE("the first run that does not hold ends a cell", "[study]") {
    const Setup setup = built_in(0);
    const double limit = small_motion(setup).limit(method_named("verlet"));
    CHECK(judged(setup, "verlet", 0.2 * limit).runs == few.runs);
    CHECK(judged(setup, "verlet", 2 * limit).runs == 1);
}

TEST_CASE("backward Euler holds at any step and loses energy at long ones", "[study]") {
    const Setup setup = built_in(0);
    const Verdict coarse = judged(setup, "backward_euler", 0.05);
    CHECK(coarse.state == Stability::lossy);
    CHECK(coarse.lost > most_loss);
    CHECK(judged(setup, "backward_euler", 1e-5).state == Stability::stable);
}

TEST_CASE("methods for scenes that conserve energy are refused with damping, and say why", "[study]") {
    const Verdict verdict = judged(built_in(7), "srkn4", 1e-4);
    CHECK(verdict.state == Stability::refused);
    CHECK(verdict.runs == 0);
    CHECK_THAT(verdict.why, Catch::Contains("conserve energy"));
}

TEST_CASE("drape's own choice holds on every mesh with every option", "[study]") {
    for (const StabilityCloth& cloth : built_in_cloths()) {
        for (const double spring_constant : {1e-2, 1e3, 1e8}) {
            const Setup setup = with_spring_constant(cloth.setup, spring_constant);
            const Verdict verdict = judge_auto(setup, small_motion(setup).all.omega, few);
            CAPTURE(cloth.mesh, cloth.options, spring_constant, verdict.method, verdict.step, verdict.why,
                    verdict.gained);
            CHECK(holds(verdict.state));
        }
    }
}
