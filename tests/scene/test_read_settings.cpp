#include <catch2/catch.hpp>

#include "base/names.h"
#include "integrate/method.h"
#include "support/scene_file.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("a method and a step may be asked for", "[scene]") {
    std::vector<std::string> known = names_of(methods());
    known.insert(known.begin(), "auto");
    for (const std::string& method : known) {
        const auto scene = scene_of(with_cloth("[accuracy]\nmethod = \"" + method + "\"\n"));
        CHECK(scene.accuracy.method == method);
    }
    CHECK(scene_of(with_cloth("[accuracy]\nstep = \"20 us\"\n")).accuracy.step == 2e-5);
    CHECK(error_of(with_cloth("[accuracy]\nstep = 0\n")) == "scene.toml:5:8: step must be positive, got 0 s");
    CHECK(error_of(with_cloth("[accuracy]\nmethod = \"varlet\"\n")) ==
          "scene.toml:5:10: unknown method \"varlet\"; did you mean \"verlet\"? (known: " + joined(known) +
              ")");
}

TEST_CASE("a tolerance may be asked for, with a method but not with a step", "[scene]") {
    CHECK(scene_of(with_cloth("[accuracy]\ntolerance = \"1 mm\"\n")).accuracy.tolerance == 1e-3);
    CHECK(scene_of(with_cloth("[accuracy]\nmethod = \"verlet\"\ntolerance = 0.01\n")).accuracy.tolerance ==
          0.01);
    CHECK(error_of(with_cloth("[accuracy]\ntolerance = 0\n")) ==
          "scene.toml:5:13: tolerance must be positive, got 0 m");
    CHECK(error_of(with_cloth("[accuracy]\nstep = 0.1\ntolerance = 0.1\n")) ==
          "scene.toml:6:1: tolerance chooses the step by itself (leave out step, or tolerance)");
}

TEST_CASE("a budget may be asked for, with a method but not with a step or a tolerance", "[scene]") {
    CHECK(scene_of(with_cloth("[accuracy]\nbudget = \"2 min\"\n")).accuracy.budget == 120);
    CHECK(error_of(with_cloth("[accuracy]\nbudget = 0\n")) ==
          "scene.toml:5:10: budget must be positive, got 0 s");
    CHECK(error_of(with_cloth("[accuracy]\ntolerance = 0.1\nbudget = 9\n")) ==
          "scene.toml:6:1: budget chooses step and error by itself (leave out tolerance, or budget)");
}

TEST_CASE("air is still unless a wind is given", "[scene]") {
    CHECK_FALSE(scene_of(with_cloth("[air]\ndrag = 0.1\n")).air.aerodynamic);
    CHECK(scene_of(with_cloth("[air]\ndrag = 0.1\n")).air.drag == 0.1);
    CHECK(scene_of(with_cloth("[air]\nwind = [0, 0, 0]\n")).air.aerodynamic);
    const AirDescription air =
        scene_of(with_cloth("[scene]\nseed = 9\n[air]\nwind = [3, 0, 0.5]\ndensity = 1\nlift = 0\n"
                            "gust = { strength = 0.3, period = \"2 s\" }\n"))
            .air;
    CHECK(air.wind == Vec3(3, 0, 0.5));
    CHECK(air.density == 1);
    CHECK(air.lift == 0);
    CHECK(air.gust_strength == 0.3);
    CHECK(air.gust_period == 2);
    CHECK(air.seed == 9);
}

TEST_CASE("wrong air is refused at its place", "[scene]") {
    CHECK(error_of(with_cloth("[air]\ngust = { strength = 1 }\n")) ==
          "scene.toml:5:1: gust goes with wind only (wind = [0, 0, 0] is still air)");
    CHECK(error_of(with_cloth("[air]\ndrag = -1\n")) ==
          "scene.toml:5:8: drag must be at least 0 kg/(s m^2), got -1 kg/(s m^2)");
    CHECK(error_of(with_cloth("[air]\nwind = [1, 0, 0]\ngust = { period = 0 }\n")) ==
          "scene.toml:6:19: period must be positive, got 0 s");
    CHECK(error_of(with_cloth("[air]\nwind = [1, inf, 0]\n")) ==
          "scene.toml:5:12: wind must be a finite number, got inf");
    CHECK(error_of(with_cloth("[air]\nwint = 3\n"))
              .starts_with("scene.toml:5:1: unknown air key \"wint\"; did you mean \"wind\"?"));
}
