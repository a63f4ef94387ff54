#include "cloth/fabric.h"

#include <catch2/catch.hpp>

#include "support/meshes.h"

using namespace drape;

TEST_CASE("every preset is its measured table: weight rho t, stretch E t, bending E t^3 / (12 (1 - nu^2))",
          "[cloth]") {
    struct Row {
        const char* name;
        double density, thickness, modulus, poisson;  // [kg/m^3], [m], [Pa]
    };
    constexpr Row table[] = {
        {"cotton", 472.6, 0.318e-3, 0.821e6, 0.243},
        {"wool", 413.4, 0.568e-3, 0.170e6, 0.277},
        {"wool_lycra", 543.3, 0.328e-3, 0.076e6, 0.071},
        {"polyester", 653.2, 0.252e-3, 0.478e6, 0.381},
    };
    CHECK(fabric_presets().size() == std::size(table));
    for (const Row& row : table) {
        CAPTURE(row.name);
        const Fabric& fabric = fabric_preset(row.name);
        const double t = row.thickness;
        CHECK(fabric.thickness == Approx(t));
        CHECK(fabric.density == Approx(row.density * t));
        CHECK(fabric.stretch_model == StretchModel::membrane);
        CHECK(fabric.stretch == Approx(row.modulus * t));
        CHECK(fabric.poisson == row.poisson);
        CHECK(fabric.bending_kind == BendingKind::plate);
        CHECK(fabric.bending == Approx(row.modulus * t * t * t / 12 / (1 - row.poisson * row.poisson)));
    }
}

TEST_CASE("every preset says what it is, what it weighs and where its figures come from", "[cloth]") {
    for (const FabricPreset& preset : fabric_presets()) {
        CAPTURE(preset.name);
        const auto unit = preset.summary.find(" kg/m^2");
        REQUIRE(unit != std::string_view::npos);
        const std::string weight(preset.summary.substr(unit - 4, 4));
        CHECK(std::stod(weight) == Approx(preset.fabric.density).margin(0.005));
        CHECK(preset.source.size() > 20);
    }
}

TEST_CASE("a fabric nobody knows is answered with the nearest that is known", "[cloth]") {
    CHECK(error_of([] { fabric_preset("coton"); }).find("cotton") != std::string::npos);
}
