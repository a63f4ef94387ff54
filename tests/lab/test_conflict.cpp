#include "lab/conflict.h"

#include <catch2/catch.hpp>

#include "lab/elastic.h"
#include "mesh/pattern.h"

using namespace drape;

TEST_CASE("an obtuse triangle has two feet outside their edges and a lever as long as they stand out",
          "[lab]") {
    // apex above a point 0.4 of the base beyond its end
    const Feet feet = feet_of(lone_triangle(1, 1.4, 0.5));
    CHECK(feet.outside == Approx(2.0 / 3));
    // onto the base: foot at 1.4; onto the side (0.4, 0.5) from its foot: (-1, 0).(0.4, 0.5) / 0.41
    CHECK(feet.most_lever == Approx(1 + 0.4 / 0.41));
    CHECK(feet_of(lone_triangle(1, 0.5, 0.8)).outside == 0);
    CHECK(feet_of(make_pattern("alternating", {1, 1, 4, 4})).outside == 0);
    CHECK(feet_of(make_pattern("alternating", {1, 1, 4, 4})).most_lever == Approx(1));
    CHECK(feet_of(make_pattern("pseudo_random", {1, 1, 16, 16})).outside > 0.01);
}
