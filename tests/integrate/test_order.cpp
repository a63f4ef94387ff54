// Every method in the table is held to the orders its row states, on cloth that uses every smooth force.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/motion.h"

using namespace drape;
using namespace drape::test;

namespace {

constexpr double end = 0.1;  // [s]

// A sheet held at two corners, out of its rest shape and in motion.
struct Sheet {
    Model model;
    State start;

    explicit Sheet(double damping, const RigidMotion& motion = {}, double softer = 1) {
        Fabric fabric = bare_springs(100 / softer);
        fabric.altitude = AltitudeMode::blend;
        fabric.bending_kind = BendingKind::plate;
        fabric.bending = 0.01 / softer;
        fabric.damping = damping;
        model = model_of(jittered_square(4, "alternating", 0.2), fabric);
        const Points rest = model.cloths[0].mesh.rest;
        hold(model, {0, 4}, rest, motion);
        start = {rest + random_points(rest.cols(), 0.01, 1), random_points(rest.cols(), 0.1, 2), 0};
        place_pins(model, start);
    }
};

// How many steps: few enough that what is left of a high order's error is no round-off.
struct Steps {
    int coarsest, finest;
};
constexpr Steps usual{160, 1280};  // h omega is near 0.3 and 0.04
// Implicit methods solve equations at every step, and backward Euler shows its order only where it damps
// little: on a sheet a hundred times softer h omega is half as large at half as many steps.
constexpr Steps implicit{80, 640};
constexpr double softer = 100;

Steps steps_for(const Method& method, int order) {
    // what separate steps of springs leave over falls off late
    if (method.projects_springs) return {5120, 20480};
    if (method.is_implicit()) return implicit;
    return order > 4 ? Steps{40, 160} : usual;
}

struct Convergence {
    double order;     // slope of log error against log step
    double smallest;  // error at the smallest step [m]
};

class Trial {
public:
    Trial(const Sheet& sheet, const Surroundings& world)
        : start_(sheet.start), dynamics_(sheet.model, forces_of(sheet.model, world), nullptr) {
        // finer by far than what it judges: the methods of the highest order for either kind of dynamics
        exact_ = dynamics_.is_conservative()
                     ? integrated(method_named("srkn6"), dynamics_, start_, end, usual.finest)
                     : integrated(method_named("rk4"), dynamics_, start_, end, 4 * usual.finest);
    }
    bool conserves_energy() const { return dynamics_.is_conservative(); }
    Convergence operator()(const Method& method, int order) {
        const Steps steps = steps_for(method, order);
        const double coarse = error(method, steps.coarsest), fine = error(method, steps.finest);
        return {std::log(coarse / fine) / std::log(steps.finest / steps.coarsest), fine};
    }

private:
    double error(const Method& method, int steps) {
        return (integrated(method, dynamics_, start_, end, steps).x - exact_.x).norm();
    }
    State start_, exact_;
    Dynamics dynamics_;
};

Surroundings still_air() {
    return {};
}

Surroundings moving_air() {
    Surroundings world;
    world.air = {.drag = 0.3, .wind = {1, 0.2, -0.5}};
    return world;
}

}  // namespace

TEST_CASE("every method has the order it states where energy is conserved", "[integrate]") {
    const Sheet sheet(0), soft(0, {}, softer);
    Trial trial(sheet, still_air()), soft_trial(soft, still_air());
    REQUIRE(trial.conserves_energy());
    for (const Method& method : methods()) {
        CAPTURE(method.name);
        // measured 1.09 for symplectic Euler, 0.98 for xpbd, within 0.03 for the others
        CHECK((method.is_implicit() ? soft_trial : trial)(method, method.order).order ==
              Approx(method.order).margin(0.12));
    }
}

TEST_CASE("every method has the order it states with damping, air drag and moving pins", "[integrate]") {
    const RigidMotion swing = carry(-0.3, 0.3, {0.1, 0.05, -0.1}, {20, 0, 30});
    struct Case {
        const char* what;
        double damping;
        RigidMotion motion;
        Surroundings world;
    };
    for (const Case& c :
         {Case{"damping", 0.05, {}, still_air()}, Case{"air drag", 0, {}, moving_air()},
          Case{"moving pins", 0, swing, still_air()}, Case{"all", 0.05, swing, moving_air()}}) {
        const Sheet sheet(c.damping, c.motion), soft(c.damping, c.motion, softer);
        Trial trial(sheet, c.world), soft_trial(soft, c.world);
        REQUIRE_FALSE(trial.conserves_energy());
        for (const Method& method : methods()) {
            if (method.conservative_only()) continue;
            CAPTURE(c.what, method.name);
            // measured within 0.09 for symplectic Euler, 0.03 for the others
            CHECK((method.is_implicit() ? soft_trial : trial)(method, method.order_with_damping).order ==
                  Approx(method.order_with_damping).margin(0.12));
        }
    }
}

TEST_CASE("Takahashi-Imada unprocessed is of order two, and far better processed", "[integrate]") {
    // pins that could move but stand still switch processing off and change no force
    const Sheet standing(0, carry(0, 1, Vec3::Zero())), still(0);
    Trial unprocessed(standing, still_air()), processed(still, still_air());
    const Method& method = method_named("takahashi_imada");
    const Convergence plain = unprocessed(method, 2);
    CHECK(plain.order == Approx(2).margin(0.05));
    const double smallest = processed(method, 4).smallest;
    CHECK(smallest < 1e-3 * plain.smallest);                                 // measured 4e-4
    CHECK(smallest < 1e-4 * processed(method_named("verlet"), 2).smallest);  // measured 1.7e-5
}
