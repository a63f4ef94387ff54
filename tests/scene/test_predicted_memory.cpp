#include "scene/predicted_memory.h"

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("predicted memory grows with vertices and passes and what is drawn", "[scene]") {
    SceneDescription scene;
    scene.cloths.emplace_back();
    scene.cloths[0].pattern = "alternating";
    scene.cloths[0].pattern_size = {1, 1, 100, 100, 1};
    const double alone = predicted_memory(scene, {30, false, 0});
    const double estimated = predicted_memory(scene, {30, true, 0});
    const double drawn = predicted_memory(scene, {30, true, 2});
    CHECK(alone > 1e6);
    CHECK(estimated > alone + 1e6);
    CHECK(drawn > estimated + 1e7);
    CHECK(predicted_memory(scene, {3000, true, 0}) == estimated);  // frames are handed on
    scene.accuracy.tolerance = 1e-3;
    // but for those of a tolerance: 2 passes of positions
    CHECK(predicted_memory(scene, {3000, true, 0}) - predicted_memory(scene, {30, true, 0}) ==
          Approx(2.0 * 2970 * 101 * 101 * 24));
    scene.cloths[0].pattern_size = {1, 1, 200, 200, 1};
    CHECK(predicted_memory(scene, {30, true, 0}) > 2 * estimated);
    CHECK(free_memory() > 1e8);
}
