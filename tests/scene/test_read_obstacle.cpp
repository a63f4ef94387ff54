#include <catch2/catch.hpp>

#include "base/error.h"
#include "obstacle/obstacle.h"
#include "scene/builder.h"
#include "support/scene_file.h"

using namespace drape;
using namespace drape::test;

namespace {

// `keys` start at line 5
std::string with_obstacle(const std::string& keys) {
    return with_cloth("[[obstacle]]\n" + keys);
}

}  // namespace

TEST_CASE("every kind of obstacle reads with nothing but its shape, and with each key it knows", "[scene]") {
    for (const SolidKind& kind : solid_kinds()) {
        CAPTURE(kind.name);
        const std::string shape = cat("shape = \"", kind.name, "\"\n");
        CHECK(scene_of(with_obstacle(shape)).obstacles.at(0).shape == kind.name);
        for (const std::string_view key : kind.keys) {
            CAPTURE(key);
            // a text is a value of no key's type, so the message shows that the key is known
            CHECK(error_of(with_obstacle(shape + cat(key, " = false\n")))
                      .starts_with(cat("scene.toml:6:", key.size() + 4, ": ", key, ": expected ")));
        }
    }
}

TEST_CASE("an obstacle reads its numbers with units, and its motion", "[scene]") {
    const ObstacleDescription torus =
        scene_of(with_obstacle(
                     "shape = \"torus\"\ncentre = [0, \"30 cm\", 0]\naxis = [0, 0, 1]\nradius = \"20 cm\"\n"
                     "tube_radius = 0.05\nfriction = 0\ncolour = \"#ffffff\"\n"
                     "motion = [{ t = 0 }, { t = \"1 s\", rotate_deg = [0, 720, 0] }]\n"
                     "about = [0, \"5 cm\", 0]\n"))
            .obstacles.at(0);
    CHECK(torus.parameters.centre == Vec3(0, 0.3, 0));
    CHECK(torus.parameters.axis == Vec3(0, 0, 1));
    CHECK(torus.parameters.radius == 0.2);
    CHECK(torus.parameters.tube_radius == 0.05);
    CHECK(torus.friction == 0);
    CHECK(torus.colour == Colour{1, 1, 1});
    REQUIRE(torus.motion.size() == 2);
    CHECK(torus.motion[1].rotate_deg == Vec3(0, 720, 0));
    CHECK(torus.about == Vec3(0, 0.05, 0));
}

TEST_CASE("an obstacle turns about its centre, or about the point it names", "[scene]") {
    const std::string ball =
        "shape = \"sphere\"\ncentre = [1, 2, 3]\nradius = 0.2\nmotion = [{ t = 0 }, { t = 1, rotate_deg = "
        "[0, "
        "0, 90] }]\n";
    const auto centre_of = [](const std::string& obstacle) {
        const Obstacle built = build_scene(scene_of(with_obstacle(obstacle))).setup.obstacles.at(0);
        return Vec3(built.motion.at(1).pose * Vec3(1, 2, 3));
    };
    CHECK((centre_of(ball) - Vec3(1, 2, 3)).norm() < 1e-15);
    CHECK((centre_of(ball + "about = [0, 0, 0]\n") - Vec3(-2, 1, 3)).norm() < 1e-15);
}

TEST_CASE("a mesh obstacle reads its file, place and thickness, and needs the file", "[scene]") {
    const ObstacleDescription mesh =
        scene_of(with_obstacle("shape = \"mesh\"\nmesh = \"chair.obj\"\nthickness = \"2 mm\"\n"
                               "place = { translate = [0, 1, 0], scale = 2 }\nfriction = 0.5\n"))
            .obstacles.at(0);
    CHECK(mesh.mesh == "chair.obj");
    CHECK(mesh.thickness == Approx(0.002));
    CHECK(mesh.placement.translate == Vec3(0, 1, 0));
    CHECK(mesh.placement.scale == 2);
    CHECK(mesh.friction == 0.5);
    CHECK(error_of(with_obstacle("shape = \"mesh\"\n")).starts_with("scene.toml:4:1: mesh: mesh is missing"));
    CHECK(error_of(with_obstacle("shape = \"mesh\"\nmesh = \"\"\n")) ==
          "scene.toml:6:8: mesh must name a file");
    CHECK(error_of(with_obstacle("shape = \"mesh\"\nmesh = \"a.obj\"\nthickness = 0\n"))
              .starts_with("scene.toml:7:13: thickness must be positive"));
    CHECK(error_of(with_obstacle("shape = \"mesh\"\nradius = 1\n"))
              .starts_with("scene.toml:6:1: unknown mesh key \"radius\""));
}

TEST_CASE("wrong obstacles are refused at their place", "[scene]") {
    CHECK(error_of(with_obstacle("radius = 1\n")) == "scene.toml:4:1: obstacle: shape is missing");
    CHECK(error_of(with_obstacle("shape = \"spere\"\n"))
              .starts_with(
                  "scene.toml:5:9: unknown obstacle \"spere\"; did you mean \"sphere\"? (known: plane, "));
    CHECK(error_of(with_obstacle("shape = \"sphere\"\nradious = 1\n")) ==
          "scene.toml:6:1: unknown sphere key \"radious\"; did you mean \"radius\"? (known: shape, centre, "
          "radius, "
          "friction, motion, about, colour)");
    CHECK(error_of(with_obstacle("shape = \"sphere\"\nheight = 1\n"))
              .starts_with("scene.toml:6:1: unknown sphere key \"height\""));
    CHECK(error_of(with_obstacle("shape = \"sphere\"\nradius = -1\n")) ==
          "scene.toml:6:10: radius must be positive, got -1 m");
    CHECK(error_of(with_obstacle("shape = \"box\"\nsize = [1, 0, 1]\n")) ==
          "scene.toml:6:12: size must be positive, got 0 m");
    CHECK(error_of(with_obstacle("shape = \"sphere\"\nfriction = -0.1\n")) ==
          "scene.toml:6:12: friction must be at least 0, got -0.1");
    CHECK(error_of(with_obstacle("shape = \"sphere\"\nmotion = 3\n")) ==
          "scene.toml:6:10: motion: expected an array, found the integer 3");
    CHECK(error_of(with_cloth("[obstacle]\nshape = \"sphere\"\n")) ==
          "scene.toml:4:1: obstacle: expected an array of tables, found one (write [[obstacle]])");
    CHECK(error_of("schema = 1\nobstacle = [3]\n[[cloth]]\npattern = {}\n") ==
          "scene.toml:2:13: obstacle: expected a table, found the integer 3");
}

TEST_CASE("what only the kind itself knows is checked too, at the obstacle's place", "[scene]") {
    CHECK(error_of(with_obstacle("shape = \"plane\"\nnormal = [0, 0, 0]\n")).starts_with("scene.toml:4:1: "));
    CHECK(error_of(with_obstacle("shape = \"torus\"\nradius = 0.1\ntube_radius = 0.2\n"))
              .starts_with("scene.toml:4:1: "));
}
