// Coulomb's law on an inclined plane, by every method.
#include "lab/sliding.h"

#include <catch2/catch.hpp>

#include "contact/smooth_friction.h"
#include "integrate/method.h"

using namespace drape;

TEST_CASE("a cloth on a slope below its friction angle moves under 1 mm in 2 s", "[contact]") {
    for (const Method& method : methods()) {
        if (method.conservative_only()) continue;
        for (const double slope : {0.0, 0.2, 0.4, 0.49}) {
            CAPTURE(method.name, slope);
            const Slide slide = slide_down(slope, 0.5, method.name);
            CHECK(slide.way < 1e-3);  // measured: 1.5e-5 m
            // implicit methods' smooth friction holds against a creep
            CHECK(std::abs(slide.speed) < (method.is_implicit() ? SmoothFriction::creep : 1e-6));
        }
    }
}

TEST_CASE("a cloth on a slope above its friction angle slides with g (sin - mu cos)", "[contact]") {
    for (const double friction : {0.0, 0.3, 0.5}) {
        for (const double beyond : {0.02, 0.3, 1.0}) {
            CAPTURE(friction, beyond);
            CHECK(
                slide_down(friction + beyond, friction).acceleration ==
                Approx(sliding_acceleration(friction + beyond, friction)).epsilon(1e-6));  // measured: 2e-13
        }
    }
}

TEST_CASE("below its friction angle cloth creeps under 1 mm in 2 s of long steps, and above it slides",
          "[contact]") {
    constexpr double step = 1.0 / 120;
    for (const Method& method : methods()) {
        if (!method.is_implicit()) continue;
        CAPTURE(method.name);
        for (const double slope : {0.2, 0.49})
            CHECK(slide_down(slope, 0.5, method.name, step).way < 1e-3);  // measured 2.1e-4
        for (const double slope : {0.52, 0.8})
            CHECK(slide_down(slope, 0.5, method.name, step).speed ==
                  Approx(2 * sliding_acceleration(slope, 0.5)).epsilon(0.02));  // measured 1.3e-2
    }
}
