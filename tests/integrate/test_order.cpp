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

    explicit Sheet(double damping, const RigidMotion& motion = {}) {
        Fabric fabric = bare_springs(100);
        fabric.altitude = AltitudeMode::blend;
        fabric.bending_kind = BendingKind::plate;
        fabric.bending = 0.01;
        fabric.damping = damping;
        model = model_of(jittered_square(4, "alternating", 0.2), fabric);
        const Points rest = model.cloths[0].mesh.rest;
        hold(model, {0, 4}, rest, motion);
        start = {rest + random_points(rest.cols(), 0.01, 1), random_points(rest.cols(), 0.1, 2), 0};
        place_pins(model, start);
    }
};

constexpr int coarsest = 160, finest = 1280;  // steps; h omega is near 0.3 and 0.04

struct Convergence {
    double order;     // slope of log error against log step
    double smallest;  // error at the smallest step [m]
};

class Trial {
public:
    Trial(const Sheet& sheet, const Surroundings& world)
        : start_(sheet.start), dynamics_(sheet.model, forces_of(sheet.model, world), nullptr) {
        exact_ = integrated(method_named("takahashi_imada"), dynamics_, start_, end, 8 * finest);
    }
    bool conserves_energy() const { return dynamics_.is_conservative(); }
    Convergence operator()(const Method& method) {
        const double coarse = error(method, coarsest), fine = error(method, finest);
        return {std::log(coarse / fine) / std::log(finest / coarsest), fine};
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
    const Sheet sheet(0);
    Trial trial(sheet, still_air());
    REQUIRE(trial.conserves_energy());
    for (const Method& method : methods()) {
        CAPTURE(method.name);
        CHECK(trial(method).order == Approx(method.order).margin(0.12));  // measured 1.08, 2.00, 4.00
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
        const Sheet sheet(c.damping, c.motion);
        Trial trial(sheet, c.world);
        REQUIRE_FALSE(trial.conserves_energy());
        for (const Method& method : methods()) {
            CAPTURE(c.what, method.name);
            // measured within 0.09 for symplectic Euler, 0.03 for the others
            CHECK(trial(method).order == Approx(method.order_with_damping).margin(0.12));
        }
    }
}

TEST_CASE("Takahashi-Imada unprocessed is of order two, and far better processed", "[integrate]") {
    // pins that could move but stand still switch processing off and change no force
    const Sheet standing(0, carry(0, 1, Vec3::Zero())), still(0);
    Trial unprocessed(standing, still_air()), processed(still, still_air());
    const Method& method = method_named("takahashi_imada");
    const Convergence plain = unprocessed(method);
    CHECK(plain.order == Approx(2).margin(0.05));
    const double smallest = processed(method).smallest;
    CHECK(smallest < 1e-3 * plain.smallest);                              // measured 4e-4
    CHECK(smallest < 1e-4 * processed(method_named("verlet")).smallest);  // measured 1.7e-5
}
