#include "video/timeline.h"

#include <catch2/catch.hpp>

using namespace drape;
using Order = std::vector<int>;

TEST_CASE("a boomerang comes back without showing a turn twice", "[video]") {
    CHECK(play_order(4, false, 1) == Order{0, 1, 2, 3});
    CHECK(play_order(4, true, 1) == Order{0, 1, 2, 3, 2, 1});
    CHECK(play_order(4, true, 2) == Order{0, 1, 2, 3, 2, 1, 0, 1, 2, 3, 2, 1});
    CHECK(play_order(3, false, 2) == Order{0, 1, 2, 0, 1, 2});
    CHECK(play_order(2, true, 1) == Order{0, 1});
    CHECK(play_order(1, true, 2) == Order{0, 0});
}

TEST_CASE("what is faster than a format shows leaves frames out evenly and lasts as long", "[video]") {
    const Order order = play_order(12, false, 1);
    CHECK(thinned(order, 60, 60) == order);
    CHECK(thinned(order, 7.5, 60) == order);
    CHECK(thinned(order, 120, 60) == Order{0, 2, 4, 6, 8, 10});
    CHECK(thinned(order, 75, 50) == Order{0, 1, 3, 4, 6, 7, 9, 10});
    CHECK(thinned(order, 1e9, 50) == Order{0});
}
