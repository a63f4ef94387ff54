#include "scene/overrides.h"

#include <catch2/catch.hpp>

#include "support/scene_file.h"

using namespace drape;
using namespace drape::test;

namespace {

const std::string scene = with_cloth("fabric = \"wool\"\n");

}  // namespace

TEST_CASE("an override by --set changes a key that is there and makes one that is not", "[scene]") {
    CHECK(scene_of(scene, {"cloth.0.fabric=polyester"}).cloths[0].fabric_name == "polyester");
    CHECK(scene_of(scene, {"cloth[0].fabric=\"polyester\""}).cloths[0].fabric_name == "polyester");
    CHECK(scene_of(scene, {"render.overlay=wire"}).look.overlay == "wire");
    CHECK(scene_of(scene, {"scene.duration=2", "scene.duration=3"}).duration == 3);
    CHECK(scene_of(scene, {"scene.duration=20 ms", "scene.frame_rate=100"}).frames() == 2);
    CHECK(scene_of(scene, {"scene.gravity=[0, 0, 0]"}).gravity == Vec3::Zero());
    CHECK(scene_of(scene, {"scene.gravity=[0, 0, 0]", "scene.gravity[1]=-1"}).gravity == Vec3(0, -1, 0));
    CHECK(scene_of(scene, {"cloth.0.place.translate=[0,1,0]"}).cloths[0].placement.translate.y() == 1);
    CHECK(scene_of(scene, {"cloth.0.fabric={ preset = \"wool\", density = 1 }"}).cloths[0].fabric.density ==
          1);
    CHECK(scene_of(scene, {"cloth=[{ pattern = {} }, { pattern = {} }]"}).cloths.size() == 2);
    CHECK(scene_of("schema = 1\n", {"cloth=[{ pattern = {} }]"}).cloths.size() == 1);
}

TEST_CASE("an override by --set reaches into what the scene writes in short", "[scene]") {
    const Fabric wool = scene_of(scene, {}).cloths[0].fabric;
    const auto light = scene_of(scene, {"cloth.0.fabric.density=0.1"}).cloths[0];
    CHECK(light.fabric_name == "wool");
    CHECK(light.fabric.density == 0.1);
    CHECK(light.fabric.stretch == wool.stretch);
    const Fabric bent = scene_of(scene, {"cloth.0.fabric.bending=1e-3", "cloth.0.fabric.bending.poisson=0.1",
                                         "cloth.0.fabric.altitude=all", "cloth.0.fabric.altitude.ratio=2"})
                            .cloths[0]
                            .fabric;
    CHECK(bent.bending == 1e-3);
    CHECK(bent.poisson == 0.1);
    CHECK(bent.altitude == AltitudeMode::all);
    CHECK(bent.altitude_ratio == 2);
}

TEST_CASE("an override by --set that goes wrong says so with its own words as the place", "[scene]") {
    CHECK(
        error_of(scene, {"scene.durration=2"}) ==
        "--set scene.durration=2: unknown scene key \"durration\"; did you mean \"duration\"? (known: name, "
        "duration, frame_rate, gravity, seed)");
    CHECK(error_of(scene, {"rendr.overlay=wire"})
              .starts_with("--set rendr.overlay=wire: unknown scene file key"));
    CHECK(error_of(scene, {"scene.duration=-1"}) ==
          "--set scene.duration=-1: duration must be positive, got -1 s");
    CHECK(error_of(scene, {"scene.duration=nan"})
              .starts_with("--set scene.duration=nan: duration must be a finite"));
    CHECK(error_of(scene, {"cloth.1.fabric=wool"}) ==
          "--set cloth.1.fabric=wool: no element \"1\" in an array of 1 (they count from 0)");
    CHECK(error_of(scene, {"cloth.fabric=wool"}) ==
          "--set cloth.fabric=wool: no element \"fabric\" in an array of 1 (they count from 0)");
    CHECK(error_of(scene, {"schema.s=1"}) ==
          "--set schema.s=1: no key \"s\" in the integer 1, which is not a table");
    CHECK(error_of(scene, {"cloth.0.fabric.densty=1"}).find("did you mean \"density\"?") !=
          std::string::npos);
    CHECK(error_of(scene, {"cloth.0.fabric={ preset = 1 }"}) ==
          "--set cloth.0.fabric={ preset = 1 }: fabric: expected a text, found the integer 1");
}

TEST_CASE("an override by --set that is no KEY=VALUE is refused", "[scene]") {
    CHECK(error_of(scene, {"duration"}) == "--set duration: expected KEY=VALUE");
    CHECK(error_of(scene, {"=1"}) == "--set =1: expected KEY=VALUE");
    CHECK(error_of(scene, {"scene..name=x"}).starts_with("--set scene..name=x: an empty part in the key"));
    CHECK(error_of(scene, {"cloth[0]fabric=x"}) == "--set cloth[0]fabric=x: expected . or [ after ]");
    CHECK(error_of(scene, {"scene.name="}) == "--set scene.name=: \"\" is not a TOML value");
    CHECK(error_of(scene, {"scene.gravity=[0, 1"}) ==
          "--set scene.gravity=[0, 1: \"[0, 1\" is not a TOML value");
    CHECK(error_of(scene, {"scene.name=1\nschema = 2"}).find("is not a TOML value") != std::string::npos);
    CHECK(error_of(scene, {std::string(100'000, '.') + "=1"}).find('\n') == std::string::npos);
}
