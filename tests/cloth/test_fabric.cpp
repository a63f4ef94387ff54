#include "cloth/fabric.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/meshes.h"

using namespace drape;

TEST_CASE(
    "a preset of a material is a plate of it: weight rho t, stretch E t, bending E t^3 / (12 (1 - nu^2))",
    "[cloth]") {
    struct Row {
        const char* name;
        double density, thickness, modulus, poisson;  // [kg/m^3], [m], [Pa]
    };
    constexpr Row table[] = {
        {"wool_lycra", 543.3, 0.328e-3, 0.076e6, 0.071},
        {"paper", 735, 0.102e-3, 5e9, 0.3},
        {"rubber", 950, 1e-3, 1.5e6, 0.5},
    };
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

TEST_CASE("a preset of calibrated cloth stretches as its table says and bends several times as hard",
          "[cloth]") {
    struct Row {
        const char* name;
        double density, thickness, modulus, poisson;  // [kg/m^3], [m], [Pa]
    };
    for (const Row& row :
         {Row{"cotton", 472.6, 0.318e-3, 0.821e6, 0.243}, Row{"wool", 413.4, 0.568e-3, 0.170e6, 0.277},
          Row{"polyester", 653.2, 0.252e-3, 0.478e6, 0.381}}) {
        CAPTURE(row.name);
        const Fabric& fabric = fabric_preset(row.name);
        const double t = row.thickness;
        CHECK(fabric.thickness == Approx(t));
        CHECK(fabric.density == Approx(row.density * t));
        CHECK(fabric.stretch == Approx(row.modulus * t));
        CHECK(fabric.poisson == row.poisson);
        const double plate = row.modulus * t * t * t / 12 / (1 - row.poisson * row.poisson);
        CHECK(fabric.bending > 4 * plate);
        CHECK(fabric.bending < 14 * plate);
    }
}

TEST_CASE("a preset of a cloth bends as cantilever tests say", "[cloth]") {
    struct Row {
        const char* name;
        double density, bending_length;  // [kg/m^2], [m]
    };
    // (B / w)^(1/3): of cloths some 1.2 to 3 cm
    for (const Row& row :
         {Row{"cotton", 0.1503, 0.0186}, Row{"wool", 0.2348, 0.0198}, Row{"polyester", 0.1646, 0.0183},
          Row{"silk", 0.0434, 0.0133}, Row{"denim", 0.324, 0.0241}, Row{"canvas", 0.407, 0.0230}}) {
        CAPTURE(row.name);
        const Fabric& fabric = fabric_preset(row.name);
        CHECK(fabric.density == Approx(row.density).epsilon(1e-3));
        CHECK(std::cbrt(fabric.bending / (fabric.density * 9.80665)) ==
              Approx(row.bending_length).epsilon(0.01));
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
