#include "compare/cache_difference.h"

#include <cmath>

#include <catch2/catch.hpp>

using namespace drape;

namespace {

Cache still(int samples, int vertices) {
    Cache cache;
    for (int s = 0; s < samples; ++s) {
        cache.samples.push_back(Points::Zero(3, vertices));
        cache.times.push_back(s);
    }
    return cache;
}

}  // namespace

TEST_CASE("the worst sample, the furthest vertex and the first difference are found", "[compare]") {
    const Cache reference = still(5, 4);
    Cache cache = reference;
    CHECK(cache_difference(cache, reference).from == -1);
    cache.samples[2].col(1) = Vec3(3e-3, 0, 4e-3);  // rms 2.5 mm
    for (int v = 0; v < 4; ++v) cache.samples[4].col(v) = Vec3(0, 4e-3, 0);
    const CacheDifference apart = cache_difference(cache, reference);
    CHECK(apart.from == 2);
    REQUIRE(apart.rms_each.size() == 5);
    CHECK(apart.rms_each[2] == Approx(2.5e-3));
    CHECK(apart.rms_each[3] == 0);
    CHECK(apart.sample == 4);
    CHECK(apart.rms_m == Approx(4e-3));
    CHECK(apart.vertex == 1);
    CHECK(apart.most_m == Approx(5e-3));
}

TEST_CASE("a position that is not a number is infinitely far away", "[compare]") {
    const Cache reference = still(2, 3);
    Cache cache = reference;
    cache.samples[1](0, 2) = std::nan("");
    const CacheDifference apart = cache_difference(cache, reference);
    CHECK(std::isinf(apart.rms_m));
    CHECK(apart.vertex == 2);
    CHECK(cache_difference(cache, cache).from == -1);
}

TEST_CASE("Hausdorff's distance is the largest of all samples for caches of any number of vertices",
          "[compare]") {
    const Cache reference = still(3, 4);
    Cache cache = still(3, 6);
    CHECK(largest_hausdorff(cache, reference) == 0);
    cache.samples[1].col(5) = Vec3(0, 2, 0);
    cache.samples[2].col(0) = Vec3(0, 0, 1);
    CHECK(largest_hausdorff(cache, reference) == Approx(2));
}
