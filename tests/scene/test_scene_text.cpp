#include "scene/scene_text.h"

#include <catch2/catch.hpp>

#include "support/scene_file.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("the effective scene, read back, is the same effective scene", "[scene]") {
    const std::string rich = R"(schema = 1
[scene]
name = "a \"quoted\" \\ name\n\u00e9"
duration = 2.3
gravity = [0.1, -9.81, 1e-300]
[accuracy]
method = "verlet"
step = "7 us"
[[cloth]]
mesh = "m.obj"
place = { rotate_deg = [10, 20, 30.1] }
start = { mesh = "s.obj", velocity = [1e15, 0, 0] }
fabric = { preset = "wool", bending = 0, stretch = { model = "spring_constant", value = 3 } }
pins = [{ near = [0, 1, 0], within = "2 cm" }, { box = [[1, 1, 1], [0, 0, 0]], rigid = true, about = [0, 0, 0] },
        { boundary = 1, motion = [{ t = 0 }, { t = "0.1 s", translate = [0, "1 mm", 0] }] }]
colour = { stripe = "#010203" }
[[cloth]]
pattern = { name = "one_way", size = [0.3, 0.7], divisions = [3, 7] }
fabric = { bending = { kind = "spring", value = 0.1 }, altitude = "compressed", damping = 0.3, membrane = { kind = "stvk", poisson = 0.21 } }
stripes = false
[[obstacle]]
shape = "plane"
[[obstacle]]
shape = "sphere"
radius = 0.123456789012345678
motion = [{ t = 1, rotate_deg = [0, 1, 0] }]
about = [1, 0.2, 3]
[[obstacle]]
shape = "capsule"
colour = "#000000"
[[obstacle]]
shape = "box"
rotate_deg = [0, 45, 0]
rounding = 0.01
[[obstacle]]
shape = "cylinder"
[[obstacle]]
shape = "torus"
[[obstacle]]
shape = "mesh"
mesh = "chair \"3\".obj"
place = { translate = [0, 1, 0.1], rotate_deg = [5, 0, 0], scale = 0.3 }
thickness = "2.5 mm"
motion = [{ t = 1, translate = [0, 1, 0] }]
[air]
drag = 0.5
wind = [1, 2, 3]
gust = { strength = 0.2 }
[render]
camera = { from = [1, 2, 3], at = [0, 0, 0] }
overlay = "wire"
ground = false
[expect]
outcome = "runs"
largest_strain = 0.1
fastest = 12.5
)";
    const std::string refused = "[expect]\noutcome = \"refused\"\nbecause = \"no \\\"area\\\"\"\n";
    for (const std::string& source : {rich, with_cloth(""), with_cloth(refused)}) {
        const std::string text = scene_text(scene_of(source));
        CAPTURE(text);
        CHECK(scene_text(scene_of(text)) == text);
    }
    const ObstacleDescription mesh = scene_of(scene_text(scene_of(rich))).obstacles.back();
    CHECK(mesh.mesh == "chair \"3\".obj");
    CHECK(mesh.placement.scale == 0.3);
    CHECK(mesh.thickness == 0.0025);
}

TEST_CASE("the effective scene shows defaults and overrides alike", "[scene]") {
    const std::string text = scene_text(scene_of(with_cloth(""), {"scene.duration=1.5 s"}));
    CHECK(text.find("duration = 1.5\n") != std::string::npos);
    CHECK(text.find("frame_rate = 30\n") != std::string::npos);
    CHECK(text.find("preset = \"cotton\"") != std::string::npos);
    CHECK(text.find("overlay = \"none\"\n") != std::string::npos);
}
