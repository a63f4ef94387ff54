#include "compare/density.h"

#include <vector>

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("the window with most marks is found wherever it lies", "[compare]") {
    constexpr int width = 50, height = 40, side = 8;
    const auto x = GENERATE(0, 13, 42), y = GENERATE(0, 20, 32);
    CAPTURE(x, y);
    std::vector<std::uint8_t> marked(width * height);
    marked[3 * width + 25] = marked[30 * width + 6] = 1;  // others, too few
    for (int v = y; v < y + side; ++v)
        for (int u = x; u < x + side; ++u) marked[static_cast<size_t>(v * width + u)] = 1;
    const DensestWindow window = densest_window(marked, width, height, side);
    CHECK(window.share == 1);
    CHECK(window.x == x);
    CHECK(window.y == y);
}

TEST_CASE("a picture smaller than the window is the window", "[compare]") {
    const std::vector<std::uint8_t> marked{0, 1, 0, 0, 0, 0};
    CHECK(densest_window(marked, 3, 2, 32).share == Approx(1.0 / 6));
    CHECK(densest_window(std::vector<std::uint8_t>(6), 3, 2, 32).share == 0);
}
