#include <catch2/catch.hpp>

#include "cloth/fabric.h"
#include "support/scene_file.h"

using namespace drape;
using namespace drape::test;

namespace {

Fabric fabric_of(const std::string& fabric) {
    return scene_of(with_cloth("fabric = " + fabric + "\n")).cloths.at(0).fabric;
}

std::string fabric_error(const std::string& fabric) {
    return error_of(with_cloth("fabric = " + fabric + "\n"));
}

}  // namespace

TEST_CASE("every preset reads by its name, and a slip names the nearest", "[scene]") {
    for (const FabricPreset& preset : fabric_presets()) {
        CAPTURE(preset.name);
        const ClothDescription cloth =
            scene_of(with_cloth("fabric = \"" + std::string(preset.name) + "\"\n")).cloths.at(0);
        CHECK(cloth.fabric_name == preset.name);
        CHECK(cloth.fabric.density == preset.fabric.density);
        CHECK(cloth.fabric.bending == preset.fabric.bending);
    }
    CHECK(fabric_error("\"coton\"")
              .starts_with(
                  "scene.toml:4:10: unknown fabric \"coton\"; did you mean \"cotton\"? (known: cotton, "));
    CHECK(fabric_error("7") == "scene.toml:4:10: fabric: expected a table, found the integer 7");
}

TEST_CASE("a table fabric over nothing has no altitude springs, no bending and no damping", "[scene]") {
    const Fabric bare =
        fabric_of("{ density = 0.2, stretch = { model = \"spring_constant\", value = 500 } }");
    CHECK(bare.density == 0.2);
    CHECK(bare.stretch_model == StretchModel::spring_constant);
    CHECK(bare.stretch == 500);
    CHECK(bare.altitude == AltitudeMode::none);
    CHECK(bare.bending_kind == BendingKind::none);
    CHECK(bare.bending == 0);
    CHECK(bare.damping == 0);
}

TEST_CASE("a table fabric over a preset changes what it names and nothing else", "[scene]") {
    const Fabric& cotton = fabric_preset("cotton");
    const ClothDescription cloth =
        scene_of(
            with_cloth("fabric = { preset = \"cotton\", thickness = \"2 mm\", bending = 0, damping = 0 }\n"))
            .cloths.at(0);
    CHECK(cloth.fabric_name == "cotton");
    CHECK(cloth.fabric.thickness == 2e-3);
    CHECK(cloth.fabric.bending_kind == BendingKind::none);
    CHECK(cloth.fabric.damping == 0);
    CHECK(cloth.fabric.density == cotton.density);
    CHECK(cloth.fabric.stretch == cotton.stretch);
    CHECK(cloth.fabric.altitude == cotton.altitude);
    // one ratio is told of both
    CHECK(cotton.membrane == MembraneKind::none);
    CHECK(cotton.membrane_poisson == cotton.poisson);
    CHECK(fabric_of("{ preset = \"cotton\", bending = 1e-5 }").bending_kind == cotton.bending_kind);
    CHECK(fabric_error("{ preset = \"cottn\" }")
              .starts_with("scene.toml:4:21: unknown fabric \"cottn\"; did you"));
}

TEST_CASE("each choice of a fabric reads by its word", "[scene]") {
    CHECK(fabric_of("{ stretch = { model = \"membrane\", value = 50 } }").stretch_model ==
          StretchModel::membrane);
    CHECK(fabric_of("{ stretch = { model = \"force_per_strain\", value = 50 } }").stretch_model ==
          StretchModel::force_per_strain);
    CHECK(fabric_of("{ altitude = \"shortest\" }").altitude == AltitudeMode::shortest);
    CHECK(fabric_of("{ altitude = { mode = \"all\", ratio = 2 } }").altitude_ratio == 2);
    CHECK(fabric_of("{ altitude = { mode = \"compressed\", beyond = 0.1 } }").compressed_beyond == 0.1);
    CHECK(fabric_of("{ altitude = \"blend\" }").altitude == AltitudeMode::blend);
    CHECK(fabric_of("{ altitude = \"none\" }").altitude == AltitudeMode::none);
    CHECK(fabric_of("{ membrane = \"stvk\" }").membrane == MembraneKind::stvk);
    CHECK(fabric_of("{ membrane = { kind = \"neo_hookean\", poisson = 0.1 } }").membrane ==
          MembraneKind::neo_hookean);
    CHECK(fabric_of("{ membrane = { kind = \"neo_hookean\", poisson = 0.1 } }").membrane_poisson == 0.1);
    CHECK(
        fabric_of("{ membrane = \"none\", stretch = { model = \"spring_constant\", value = 5 } }").membrane ==
        MembraneKind::none);
    CHECK(fabric_of("{ bending = { kind = \"hinge\", value = 1e-5 } }").bending_kind == BendingKind::hinge);
    CHECK(fabric_of("{ bending = { kind = \"spring\", value = 0.01 } }").bending_kind == BendingKind::spring);
    CHECK(fabric_of("{ bending = { value = 1e-5, poisson = 0.5 } }").bending_kind == BendingKind::plate);
    CHECK(fabric_of("{ bending = 1e-5 }").bending_kind == BendingKind::plate);
    CHECK(fabric_of("{ bending = { kind = \"plate\", value = 0 } }").bending_kind == BendingKind::none);
    CHECK(fabric_of("{ preset = \"wool\", bending = { kind = \"none\" } }").bending == 0);
}

TEST_CASE("impossible fabrics are refused at their place", "[scene]") {
    CHECK(fabric_error("{ density = 0 }") == "scene.toml:4:22: density must be positive, got 0 kg/m^2");
    CHECK(fabric_error("{ density = -0.1 }") == "scene.toml:4:22: density must be positive, got -0.1 kg/m^2");
    CHECK(fabric_error("{ thickness = \"0 mm\" }") == "scene.toml:4:24: thickness must be positive, got 0 m");
    CHECK(fabric_error("{ damping = -1 }") == "scene.toml:4:22: damping must be at least 0, got -1");
    CHECK(fabric_error("{ stretch = { value = 0 } }") ==
          "scene.toml:4:32: stretch value must be positive, got 0 N/m");
    CHECK(fabric_error("{ stretch = { model = \"force_per_strain\", value = -1 } }") ==
          "scene.toml:4:60: stretch value must be positive, got -1 N");
    CHECK(fabric_error("{ bending = { kind = \"spring\", value = -1 } }") ==
          "scene.toml:4:49: bending value must be at least 0, got -1");
    CHECK(fabric_error("{ stretch = { model = \"membrane\" } }") ==
          "scene.toml:4:22: stretch: value is missing");
    CHECK(fabric_error("{ stretch = 500 }") ==
          "scene.toml:4:22: stretch: expected a table, found the integer 500");
    CHECK(fabric_error("{ stretch = { model = \"membrain\", value = 1 } }") ==
          "scene.toml:4:32: unknown stretch model \"membrain\"; did you mean \"membrane\"? (known: "
          "force_per_strain, spring_constant, membrane)");
    CHECK(fabric_error("{ altitude = \"shortst\" }") ==
          "scene.toml:4:23: unknown altitude mode \"shortst\"; did you mean \"shortest\"? (known: none, all, "
          "shortest, compressed, blend)");
    CHECK(fabric_error("{ altitude = { ratio = 0 } }") == "scene.toml:4:33: ratio must be positive, got 0");
    CHECK(fabric_error("{ altitude = { beyond = 1 } }") ==
          "scene.toml:4:34: beyond must be from 0 to 0.99, got 1");
    CHECK(fabric_error("{ membrane = \"neo_hookian\" }") ==
          "scene.toml:4:23: unknown membrane \"neo_hookian\"; did you mean \"neo_hookean\"? (known: none, "
          "stvk, "
          "neo_hookean)");
    CHECK(fabric_error("{ membrane = { kind = \"fem\" } }")
              .starts_with("scene.toml:4:32: unknown membrane kind"));
    CHECK(fabric_error("{ membrane = { kind = \"stvk\", poisson = 0.6 } }") ==
          "scene.toml:4:50: poisson must be above -1 and at most 0.5, got 0.6");
    CHECK(fabric_error("{ membrane = 1 }") ==
          "scene.toml:4:23: membrane: expected a table, found the integer 1");
    CHECK(fabric_error("{ stretch = { model = \"spring_constant\", value = 5 }, membrane = \"stvk\" }") ==
          "scene.toml:4:75: membrane \"stvk\" stretches by Young's modulus times thickness: stretch model "
          "must be "
          "\"membrane\" (N/m), not \"spring_constant\"");
    CHECK(fabric_error("{ bending = { value = 1e-5, poisson = 0.6 } }") ==
          "scene.toml:4:48: poisson must be above -1 and at most 0.5, got 0.6");
    CHECK(fabric_error("{ bending = { value = 1e-5, poisson = -1 } }") ==
          "scene.toml:4:48: poisson must be above -1 and at most 0.5, got -1");
    CHECK(fabric_error("{ bending = -1 }") == "scene.toml:4:22: bending must be at least 0 N m, got -1 N m");
    CHECK(fabric_error("{ bending = { kind = \"hinge\" } }") == "scene.toml:4:22: bending: value is missing");
    CHECK(fabric_error("{ preset = \"wool\", bending = { kind = \"spring\" } }") ==
          "scene.toml:4:39: bending: value is missing");
    CHECK(fabric_error("{ mass = 1 }").starts_with("scene.toml:4:12: unknown fabric key \"mass\""));
}
