#include "compare/edge_shift.h"

#include <catch2/catch.hpp>

#include "compare/picture_difference.h"
#include "compare/pictures.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("an antialiased edge that moved by half a pixel is explained but not one that moved by three",
          "[compare]") {
    const Image reference = disc(60, 60, 30, 30, 20);
    const PictureDifference near = picture_difference(disc(60, 60, 30.5, 30.2, 20), reference);
    CHECK(near.share_over > 0.03);
    CHECK(near.share_off_edges == 0);
    const PictureDifference far = picture_difference(disc(60, 60, 33, 30, 20), reference);
    CHECK(far.share_off_edges > 0.02);
}

TEST_CASE("a spot and a line that went away and another shade are no edges that moved", "[compare]") {
    const Image ground = plain(20, 20);
    Image spot = ground;
    spot.pixel(10, 10)[0] = 140;
    CHECK_FALSE(explained_by_shift(spot, ground, 10, 10, 8));
    CHECK_FALSE(explained_by_shift(ground, spot, 10, 10, 8));
    Image line = ground;
    for (int y = 0; y < 20; ++y) line.pixel(7, y)[1] = 200;
    CHECK_FALSE(explained_by_shift(line, ground, 7, 5, 8));
    CHECK_FALSE(explained_by_shift(ground, line, 7, 5, 8));
    CHECK_FALSE(explained_by_shift(plain(20, 20, 120), ground, 0, 0, 8));
    CHECK(explained_by_shift(plain(20, 20, 108), ground, 0, 0, 8));
}
