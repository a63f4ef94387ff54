#include "obstacle/kinds.h"

#include <catch2/catch.hpp>

#include "support/meshes.h"
#include "support/obstacles.h"

using namespace drape;
using namespace drape::test;

namespace {

std::string refusal(std::string_view kind, void (*spoil)(ShapeParameters&)) {
    ShapeParameters shape;
    spoil(shape);
    return error_of([&] { solid_of(kind, shape); });
}

}  // namespace

TEST_CASE("solids with impossible numbers are refused, and the message says which", "[obstacle]") {
    using S = ShapeParameters;
    for (const std::string_view round : {"sphere", "capsule", "cylinder", "torus"}) {
        CAPTURE(round);
        CHECK(refusal(round, [](S& s) { s.radius = -1; }) == "radius must be positive, got -1 m");
        CHECK(refusal(round, [](S& s) { s.radius = 0; }) == "radius must be positive, got 0 m");
        CHECK(refusal(round, [](S& s) { s.radius = NAN; }) == "radius must be positive, got nan m");
    }
    CHECK(refusal("plane", [](S& s) { s.normal.setZero(); }) == "normal must not be zero");
    CHECK(refusal("cylinder", [](S& s) { s.axis.setZero(); }) == "axis must not be zero");
    CHECK(refusal("torus", [](S& s) { s.axis.setZero(); }) == "axis must not be zero");
    CHECK(refusal("capsule", [](S& s) { s.to = s.from; }) ==
          "capsule: from and to are the same point (use a sphere)");
    CHECK(refusal("box", [](S& s) { s.size.y() = -2; }) == "size must be positive, got -2 m");
    CHECK(refusal("box", [](S& s) { s.rounding = 0.6; }) ==
          "rounding must be between 0 and half the smallest side, got 0.6 m");
    CHECK(refusal("box", [](S& s) { s.rounding = -0.1; }) ==
          "rounding must be between 0 and half the smallest side, got -0.1 m");
    CHECK(refusal("cylinder", [](S& s) { s.height = 0; }) == "height must be positive, got 0 m");
    CHECK(refusal("cylinder", [](S& s) { s.rounding = 0.2; }) ==
          "rounding must be between 0 and the smaller of radius and half height, got 0.2 m");
    CHECK(refusal("torus", [](S& s) { s.tube_radius = 0; }) == "tube_radius must be positive, got 0 m");
    CHECK(refusal("torus", [](S& s) { s.tube_radius = 0.1; }) ==
          "tube_radius must be smaller than radius, got 0.1 and 0.1 m");
}

TEST_CASE("solids with their default numbers are all possible", "[obstacle]") {
    for (const SolidKind& kind : solid_kinds()) {
        CAPTURE(kind.name);
        CHECK(refusal(kind.name, [](ShapeParameters&) {}).empty());
    }
}
