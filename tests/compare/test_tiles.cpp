#include "compare/tiles.h"

#include <catch2/catch.hpp>

#include "compare/pictures.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("tiles are those within reach of a pixel that differs and cover the picture where all do",
          "[compare]") {
    const Image reference = plain(150, 100);
    Image picture = reference;
    CHECK(changed_tiles(picture, reference, 10).empty());
    picture.pixel(30, 30)[2] += 1;  // in the middle of the first
    CHECK(changed_tiles(picture, reference, 10).size() == 1);
    picture.pixel(60, 30)[2] += 1;  // 4 pixels from the second
    const std::vector<Tile> two = changed_tiles(picture, reference, 10);
    REQUIRE(two.size() == 2);
    CHECK(two[1].left == 64);
    CHECK(two[1].right == 128);
    CHECK(changed_tiles(picture, reference, 3).size() == 1);
    int pixels = 0;
    for (const Tile& tile : changed_tiles(plain(150, 100, 7), reference, 0))
        pixels += tile.width() * tile.height();
    CHECK(pixels == 150 * 100);
}
