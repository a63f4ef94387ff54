#include "lab/jumps.h"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("round a rest shape the force of `shortest` jumps three times and that of `blend` never", "[lab]") {
    const std::vector<ForceJump> jumps = jumps_round_rest();
    CHECK(jumps.size() == 3);
    for (const ForceJump& jump : jumps) {
        CAPTURE(jump.turn_deg);
        CHECK(jump.shortest > 0.3);
        CHECK(jump.blend < 1e-6);
        CHECK(jump.energy_change < 1e-6);
    }
}

// With edges of one length an angle g apart, c = cos g, the springs on them push as (n, -(1 - c) n, -c n)
// with n.m = -c between their directions, so that |p|^2 = 1 + (1 - c)^2 + c^2 and p.q = 2 c^2 - c (1 - c)^2.
TEST_CASE("two altitudes on like edges jump as their directions say", "[lab]") {
    for (const double degrees : {30.0, 60.0, 80.0, 120.0}) {
        const double c = std::cos(degrees * std::numbers::pi / 180);
        const double squared = 1 + (1 - c) * (1 - c) + c * c, product = 2 * c * c - c * (1 - c) * (1 - c);
        const double angle = degrees * std::numbers::pi / 180;
        CAPTURE(degrees);
        CHECK(jump_at_tie(AltitudeMode::shortest, angle, 1) ==
              Approx(std::sqrt(2 - 2 * product / squared)).epsilon(1e-6));
        CHECK(jump_at_tie(AltitudeMode::blend, angle, 1) < 1e-6);
    }
}

TEST_CASE("where two altitudes tie the force of `shortest` jumps by more than itself", "[lab]") {
    CHECK(jump_at_tie(AltitudeMode::shortest, std::numbers::pi * 80 / 180, 1) > 1.4);
}
