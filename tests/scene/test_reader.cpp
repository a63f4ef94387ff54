#include "scene/reader.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "support/scene_file.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("a scene of one line per need reads, and says every default", "[scene]") {
    const SceneDescription scene = scene_of(with_cloth(""));
    CHECK(scene.name == "scene");
    CHECK(scene.duration == 1);
    CHECK(scene.frame_rate == 30);
    CHECK(scene.frames() == 30);
    CHECK(scene.gravity == Vec3(0, -9.81, 0));
    CHECK(scene.seed == 1);
    CHECK(scene.air.seed == 1);
    CHECK(scene.accuracy.method == "auto");
    CHECK_FALSE(scene.accuracy.step);
    CHECK(scene.cloths.size() == 1);
    CHECK(scene.cloths[0].fabric_name == "cotton");
    CHECK(scene.obstacles.empty());
    CHECK_FALSE(scene.air.aerodynamic);
    CHECK_FALSE(scene.look.camera);
}

TEST_CASE("every key of the scene contract's example reads", "[scene]") {
    const SceneDescription scene = scene_of(R"(schema = 1
[scene]
name = "sphere drop"
duration = 4.0            # s
frame_rate = 30
gravity = [0, -9.81, 0]
seed = 1
[accuracy]
method = "takahashi_imada"
step = "1 ms"
[[cloth]]
mesh = "../meshes/square_65.obj"
place = { translate = [0, 1, 0], rotate_deg = [0, 0, 0], scale = 1 }
start = { velocity = [0, 0, 0], scale = [1, 1, 1], mesh = "start.obj" }
fabric = { density = 0.2, thickness = "1 mm", stretch = { model = "spring_constant", value = 500 }, altitude = { mode = "blend", ratio = 1 }, bending = { kind = "plate", value = 1e-5, poisson = 0.3 }, damping = 0 }
pins = [{ near = [0, 1, 0], within = "2 cm" }, { box = [[0, 0, 0], [1, 1, 1]], motion = [{ t = 0, translate = [0, 0, 0], rotate_deg = [0, 0, 0] }, { t = 1, translate = [1, 0, 0] }] }, { boundary = 0, rigid = true }]
self_contact = false
[[obstacle]]
shape = "sphere"
centre = [0, 0.3, 0]
radius = 0.3
friction = 0.4
motion = [{ t = 0, translate = [0, 0, 0], rotate_deg = [0, 0, 0] }]
[air]
drag = 0.0                            # kg/s per m^2
wind = [3, 0, 0.5]                    # m/s
gust = { strength = 0.3, period = 1.5 }
[render]
size = [1280, 720]
camera = { from = [1.8, 1.2, 2.2], at = [0, 0.4, 0], fov_deg = 24 }
overlay = "none"
)");
    CHECK(scene.name == "sphere drop");
    CHECK(scene.frames() == 120);
    CHECK(scene.accuracy.method == "takahashi_imada");
    CHECK(scene.accuracy.step == 1e-3);
    const ClothDescription& cloth = scene.cloths.at(0);
    CHECK(cloth.mesh == "../meshes/square_65.obj");
    CHECK(cloth.placement.translate == Vec3(0, 1, 0));
    CHECK(cloth.start.mesh == "start.obj");
    CHECK(cloth.fabric.thickness == 1e-3);
    CHECK(cloth.fabric.stretch == 500);
    REQUIRE(cloth.pins.size() == 3);
    CHECK(cloth.pins[0].within == 0.02);
    CHECK(cloth.pins[1].motion.size() == 2);
    CHECK(cloth.pins[2].boundary == 0);
    CHECK(cloth.pins[2].rigid);
    CHECK(scene.obstacles.at(0).parameters.radius == 0.3);
    CHECK(scene.obstacles.at(0).friction == 0.4);
    CHECK(scene.air.wind == Vec3(3, 0, 0.5));
    CHECK(scene.air.gust_strength == 0.3);
    CHECK(scene.look.camera->from == Vec3(1.8, 1.2, 2.2));
}

TEST_CASE("the schema must be there and be 1, and is asked for before anything else", "[scene]") {
    CHECK(error_of("[[cloth]]\npattern = {}\n") == "scene.toml:1:1: schema is missing (schema = 1)");
    CHECK(error_of("schema = 2\nnew_key = 1\n") == "scene.toml:1:10: schema must be 1, found the integer 2");
    CHECK(error_of("schema = \"1\"\n") == "scene.toml:1:10: schema must be 1, found the text \"1\"");
}

TEST_CASE("a scene without cloth is refused", "[scene]") {
    CHECK(error_of("schema = 1\n") == "scene.toml:1:1: no cloth (at least one [[cloth]])");
    CHECK(error_of("schema = 1\ncloth = []\n") == "scene.toml:1:1: no cloth (at least one [[cloth]])");
    CHECK(error_of("schema = 1\n[cloth]\npattern = {}\n") ==
          "scene.toml:2:1: cloth: expected an array of tables, found one (write [[cloth]])");
}

TEST_CASE("an unknown key is refused at its place and the nearest known one is named", "[scene]") {
    CHECK(error_of("schema = 1\n[[clot]]\n") ==
          "scene.toml:2:3: unknown scene file key \"clot\"; did you mean \"cloth\"? (known: schema, scene, "
          "accuracy, cloth, obstacle, air, render, expect)");
    CHECK(error_of(with_cloth("[scene]\n  framerate = 30\n")) ==
          "scene.toml:5:3: unknown scene key \"framerate\"; did you mean \"frame_rate\"? (known: name, "
          "duration, "
          "frame_rate, gravity, seed)");
    CHECK(
        error_of(with_cloth("[scene]\nzzzzzzzzzzzzzzz = 30\n")) ==
        "scene.toml:5:1: unknown scene key \"zzzzzzzzzzzzzzz\" (known: name, duration, frame_rate, gravity, "
        "seed)");
}

TEST_CASE("fewer than one frame, or far too many, is refused", "[scene]") {
    CHECK(error_of(with_cloth("[scene]\nduration = \"10 ms\"\n")) ==
          "scene.toml:4:1: duration times frame_rate is 0.3 frames (at least 1)");
    CHECK(error_of(with_cloth("[scene]\nduration = 1e14\n")) ==
          "scene.toml:4:1: duration times frame_rate is 3e+15 frames (at most 1e+06)");
    CHECK(error_of(with_cloth("[scene]\nduration = 0\n")) ==
          "scene.toml:5:12: duration must be positive, got 0 s");
    CHECK(error_of(with_cloth("[scene]\nframe_rate = -30\n")) ==
          "scene.toml:5:14: frame_rate must be positive, got -30 frames/s");
    CHECK(scene_of(with_cloth("[scene]\nduration = \"20 ms\"\n")).frames() == 1);
}

TEST_CASE("a seed is an integer that is not negative", "[scene]") {
    CHECK(error_of(with_cloth("[scene]\nseed = -1\n")) == "scene.toml:5:8: seed must be at least 0, got -1");
    CHECK(error_of(with_cloth("[scene]\nseed = 1.5\n")) ==
          "scene.toml:5:8: seed: expected an integer, found the number 1.5");
    CHECK(scene_of(with_cloth("[scene]\nseed = 7\n")).air.seed == 7);
}

TEST_CASE("paths of a scene are relative to its file", "[scene]") {
    SceneDescription scene;
    scene.folder = "assets/scenes";
    CHECK(scene.path_to("../meshes/a.obj") == "assets/meshes/a.obj");
    CHECK(scene.path_to("/abs/a.obj") == "/abs/a.obj");
    scene.folder = "";
    CHECK(scene.path_to("a.obj") == "a.obj");
}

TEST_CASE("what is not a scene file is refused by name", "[scene]") {
    const auto refusal = [](const std::string& path) -> std::string {
        try {
            read_scene(path);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    CHECK(refusal(TEST_DATA "/no_such_scene.toml") == TEST_DATA "/no_such_scene.toml: no such file");
    CHECK(refusal(DRAPE_SOURCE_DIR "/tests") == DRAPE_SOURCE_DIR "/tests: is a folder, not a scene file");
    CHECK(refusal("/dev/zero") == "/dev/zero: too large for a scene file (at most 1 MiB)");
}
