#include <catch2/catch.hpp>

#include "support/scene_file.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("a scene may say what a run of it should come to, or nothing", "[scene]") {
    CHECK_FALSE(scene_of(with_cloth("")).expected);
    const auto runs =
        scene_of(with_cloth("[expect]\noutcome = \"runs\"\nlargest_strain = 0.5\nfastest = 3\n")).expected;
    REQUIRE(runs);
    CHECK(runs->outcome == "runs");
    CHECK(runs->largest_strain == 0.5);
    CHECK(runs->fastest == 3);
    const auto stops = scene_of(with_cloth("[expect]\noutcome = \"stops\"\nbecause = \"pushed\"\n")).expected;
    REQUIRE(stops);
    CHECK(stops->outcome == "stops");
    CHECK(stops->because == "pushed");
    CHECK_FALSE(stops->largest_strain);
}

TEST_CASE("a wrong expectation is refused at its place", "[scene]") {
    const auto error = [](const std::string& keys) { return error_of(with_cloth("[expect]\n" + keys)); };
    CHECK(error("") == "scene.toml:4:1: expect: outcome is missing");
    CHECK(error("outcome = \"walks\"\n").starts_with("scene.toml:5:11: unknown outcome \"walks\""));
    CHECK(error("outcome = \"runs\"\nbecause = \"inside\"\n") ==
          "scene.toml:6:1: because goes with refused or stops only (leave it out)");
    CHECK(error("outcome = \"refused\"\nfastest = 3\n") ==
          "scene.toml:6:1: fastest goes with runs only (leave it out)");
    CHECK(error("outcome = \"runs\"\nlargest_strain = -1\n") ==
          "scene.toml:6:18: largest_strain must be at least 0, got -1");
    CHECK(error("outcom = \"runs\"\n")
              .starts_with("scene.toml:5:1: unknown expect key \"outcom\"; did you mean \"outcome\"?"));
}
