#include "compare/picture_difference.h"

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("a pixel counts as off where any channel is more than 8 levels away", "[compare]") {
    const Image reference(10, 10);
    Image picture = reference;
    picture.pixel(3, 4)[1] = 8;
    CHECK(picture_difference(picture, reference).share_over == 0);
    picture.pixel(3, 4)[1] = 9;
    picture.pixel(7, 7)[0] = 255;
    picture.pixel(7, 7)[2] = 255;
    const PictureDifference apart = picture_difference(picture, reference);
    CHECK(apart.share_over == Approx(0.02));
    CHECK(apart.mean_levels == Approx((9 + 255 + 255) / 300.0));
    CHECK(apart.density == Approx(0.02));
    CHECK(apart.histogram[0] == 98);
    CHECK(apart.histogram[9] == 1);
    CHECK(apart.histogram[255] == 1);
}
