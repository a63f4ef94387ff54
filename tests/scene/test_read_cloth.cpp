#include <catch2/catch.hpp>

#include "scene/scene_text.h"
#include "support/scene_file.h"

using namespace drape;
using namespace drape::test;

namespace {

PinDescription pin_of(const std::string& pin) {
    return scene_of(with_cloth("pins = [" + pin + "]\n")).cloths.at(0).pins.at(0);
}

std::string pin_error(const std::string& pin) {
    return error_of(with_cloth("pins = [" + pin + "]\n"));
}

}  // namespace

TEST_CASE("a cloth has exactly one of mesh and pattern", "[scene]") {
    CHECK(error_of("schema = 1\n[[cloth]]\nfabric = \"wool\"\n") ==
          "scene.toml:2:1: a cloth needs exactly one of mesh, pattern");
    CHECK(error_of(with_cloth("mesh = \"a.obj\"\n")) ==
          "scene.toml:2:1: a cloth needs exactly one of mesh, pattern");
    CHECK(error_of("schema = 1\n[[cloth]]\nmesh = \"\"\n") == "scene.toml:3:8: mesh must name a file");
    CHECK(error_of("schema = 1\n[[cloth]]\nmesh = 3\n") ==
          "scene.toml:3:8: mesh: expected a text, found the integer 3");
    CHECK(error_of("schema = 1\n[[cloth]]\nmash = \"a.obj\"\n")
              .starts_with("scene.toml:3:1: unknown cloth key \"mash\"; did you mean \"mesh\"?"));
}

TEST_CASE("a pattern's name, sides and divisions are checked", "[scene]") {
    const auto cloth = [](const std::string& pattern) {
        return "schema = 1\n[[cloth]]\npattern = " + pattern + "\n";
    };
    const ClothDescription sheet =
        scene_of(cloth("{ name = \"one_way\", size = [2, \"50 cm\"], divisions = [64, 16] }")).cloths.at(0);
    CHECK(sheet.pattern == "one_way");
    CHECK(sheet.pattern_size.width == 2);
    CHECK(sheet.pattern_size.depth == 0.5);
    CHECK(sheet.pattern_size.columns == 64);
    CHECK(sheet.pattern_size.rows == 16);
    CHECK(sheet.pattern_size.seed == 1);
    CHECK(scene_of(cloth("{ name = \"pseudo_random\", seed = 7 }")).cloths.at(0).pattern_size.seed == 7);
    CHECK(error_of(cloth("{ seed = -1 }")).starts_with("scene.toml:3:20: seed"));
    CHECK(error_of(cloth("{ name = \"oneway\" }")) ==
          "scene.toml:3:20: unknown pattern \"oneway\"; did you mean \"one_way\"? (known: one_way, "
          "alternating, crossed, equilateral, pseudo_random, adaptive)");
    CHECK(error_of(cloth("{ size = [1, 0] }")) == "scene.toml:3:24: size must be positive, got 0 m");
    CHECK(error_of(cloth("{ size = 1 }")) ==
          "scene.toml:3:20: size: expected an array of 2, found the integer 1");
    CHECK(error_of(cloth("{ divisions = [0, 4] }")) ==
          "scene.toml:3:26: divisions must be from 1 to 1000000, got 0");
    CHECK(error_of(cloth("{ divisions = [4, 4.5] }")) ==
          "scene.toml:3:29: divisions: expected an integer, found the number 4.5");
}

TEST_CASE("a pattern covers what it is told, and an adaptive one is finer where it is told", "[scene]") {
    const auto cloth = [](const std::string& pattern) {
        return "schema = 1\n[[cloth]]\npattern = " + pattern + "\n";
    };
    const auto text_of = [](const SceneDescription& scene) { return scene_text(scene); };
    const SceneDescription annulus = scene_of(cloth("{ over = \"annulus\", hole = \"40 cm\" }"));
    CHECK(annulus.cloths.at(0).pattern_size.over == "annulus");
    CHECK(annulus.cloths.at(0).pattern_size.hole == 0.4);
    const SceneDescription outline = scene_of(cloth(
        "{ name = \"adaptive\", outline = [[0, 0], [\"2 m\", 0], [0, 1]], finer = { points = [[0.1, 0.2]], "
        "lines = [[[0, 0], [1, 0]]], finest = \"5 mm\", growth = 0.2, turn_deg = 10, "
        "curved = { mesh = \"a.obj\", positions = \"a.pc2\" } } }"));
    const ClothDescription& sheet = outline.cloths.at(0);
    CHECK(sheet.pattern_size.outline.at(1) == Eigen::Vector2d(2, 0));
    CHECK(sheet.pattern_size.finer.points.at(0) == Eigen::Vector2d(0.1, 0.2));
    CHECK(sheet.pattern_size.finer.finest == 0.005);
    CHECK(sheet.curved.positions == "a.pc2");
    // what inspect prints reads back as the same
    for (const SceneDescription& scene : {annulus, outline})
        CHECK(text_of(scene_of(text_of(scene))) == text_of(scene));
    CHECK(error_of(cloth("{ over = \"disk\" }"))
              .starts_with("scene.toml:3:20: unknown over \"disk\"; did you mean \"disc\"?"));
    CHECK(error_of(cloth("{ hole = 0.1 }")) == "scene.toml:3:13: hole goes with over = \"annulus\" only");
    CHECK(error_of(cloth("{ over = \"outline\" }")) == "scene.toml:3:20: over = \"outline\" needs outline");
    CHECK(error_of(cloth("{ name = \"adaptive\" }")) == "scene.toml:3:11: adaptive needs finer");
    CHECK(error_of(cloth("{ finer = { points = [[0, 0]] } }")) ==
          "scene.toml:3:13: finer goes with name = \"adaptive\" only");
    CHECK(error_of(cloth("{ name = \"adaptive\", finer = { growth = 1 } }")) ==
          "scene.toml:3:40: finer needs points, lines or curved");
    CHECK(error_of(cloth("{ outline = [[0, 0], [1, 1], [1, 0], [0, 1]] }"))
              .starts_with("scene.toml:3:23: outline: the sides after corners 1 and 3 meet"));
}

TEST_CASE("place and start read; a start may be flattened or mirrored, a rest shape not", "[scene]") {
    const ClothDescription cloth =
        scene_of(with_cloth("place = { translate = [0, \"1 cm\", 0], rotate_deg = [90, 0, 0], scale = 2 }\n"
                            "start = { velocity = [0, 0, 1], scale = [0.9, 1, 1], mesh = \"s.obj\" }\n"))
            .cloths.at(0);
    CHECK(cloth.placement.translate == Vec3(0, 0.01, 0));
    CHECK(cloth.placement.rotate_deg == Vec3(90, 0, 0));
    CHECK(cloth.placement.scale == 2);
    CHECK(cloth.start.velocity == Vec3(0, 0, 1));
    CHECK(cloth.start.scale == Vec3(0.9, 1, 1));
    CHECK(cloth.start.mesh == "s.obj");
    CHECK(cloth.start_mesh_place.text.ends_with("scene.toml:5:61"));
    CHECK(error_of(with_cloth("place = { scale = 0 }\n")) ==
          "scene.toml:4:19: scale must be positive, got 0");
    CHECK(scene_of(with_cloth("start = { scale = [0, -1, 1] }\n")).cloths.at(0).start.scale ==
          Vec3(0, -1, 1));
}

TEST_CASE("a pin says which vertices in exactly one way", "[scene]") {
    CHECK(pin_error("{ rigid = true }") == "scene.toml:4:9: a pin needs exactly one of near, box, boundary");
    CHECK(pin_error("{ near = [0, 0, 0], boundary = 0 }") ==
          "scene.toml:4:9: a pin needs exactly one of near, box, boundary");
    CHECK(pin_error("{ boundary = 0, within = 1 }") == "scene.toml:4:25: within goes with near only");
    CHECK(pin_error("{ boundary = -1 }") == "scene.toml:4:22: boundary must be at least 0, got -1");
    CHECK(pin_error("{ box = [[0, 0, 0]] }") ==
          "scene.toml:4:17: box: expected an array of 2, found an array of 1");
    CHECK(pin_error("3") == "scene.toml:4:9: pin: expected a table, found the integer 3");
    CHECK(pin_error("{ nera = [0, 0, 0] }")
              .starts_with("scene.toml:4:11: unknown pin key \"nera\"; did you mean \"near\"?"));

    CHECK(pin_of("{ near = [0, 1, 0] }").near == Vec3(0, 1, 0));
    CHECK_FALSE(pin_of("{ near = [0, 1, 0] }").within);
    CHECK(pin_of("{ boundary = 2, about = [0, 1, 0] }").about == Vec3(0, 1, 0));
}

TEST_CASE("a pin's box may be given by any two opposite corners", "[scene]") {
    const PinDescription pin = pin_of("{ box = [[1, 0, 3], [0, 2, \"-1 cm\"]] }");
    CHECK((*pin.box)[0] == Vec3(0, 0, -0.01));
    CHECK((*pin.box)[1] == Vec3(1, 2, 3));
}

TEST_CASE("keyframes must have times and these must increase", "[scene]") {
    CHECK(pin_of("{ boundary = 0, motion = [{ t = 0 }, { t = \"500 ms\", rotate_deg = [0, 90, 0] }] }")
              .motion.at(1)
              .t == 0.5);
    CHECK(pin_error("{ boundary = 0, motion = [{ translate = [0, 0, 0] }] }") ==
          "scene.toml:4:35: keyframe: t is missing");
    CHECK(pin_error("{ boundary = 0, motion = [{ t = 1 }, { t = 1 }] }") ==
          "scene.toml:4:52: keyframe times must increase, got 1 after 1");
}

TEST_CASE("cloth meets itself only where the scene says so", "[scene]") {
    CHECK(scene_of(with_cloth("self_contact = true\n")).cloths.at(0).self_contact);
    CHECK_FALSE(scene_of(with_cloth("self_contact = false\n")).cloths.at(0).self_contact);
    CHECK_FALSE(scene_of(with_cloth("")).cloths.at(0).self_contact);
    CHECK(scene_of(with_cloth("fabric = { friction = 0.7 }\n")).cloths.at(0).fabric.friction == 0.7);
    CHECK_THAT(error_of(with_cloth("fabric = { friction = -1 }\n")), Catch::Contains("friction"));
}

TEST_CASE("a cloth's colours are its own, the palette's where it says nothing", "[scene]") {
    const ClothColours colours =
        scene_of(with_cloth("colour = { front = \"#ff8000\" }\nstripes = false\n")).cloths.at(0).colours;
    CHECK(colours.front == Colour{1, 128 / 255.0f, 0});
    CHECK_FALSE(colours.back);
    CHECK_FALSE(colours.stripe);
    CHECK_FALSE(colours.stripes);
    CHECK(scene_of(with_cloth("")).cloths.at(0).colours.stripes);
}
