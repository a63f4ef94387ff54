#include "base/padded.h"

#include <catch2/catch.hpp>

#include "support/cloths.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("padded points are the points and zeros, and come back as they were", "[base]") {
    for (const int count : {0, 1, 2, 7}) {
        const Points points = random_points(count, 1, 1);
        PaddedPoints padded;
        Points back;
        pad(points, padded);
        unpad(padded, back);
        CHECK(padded.topRows<3>() == points);
        CHECK(padded.row(3).isZero(0));
        CHECK(back == points);
    }
}

TEST_CASE("four rows turn into lanes of their coordinates and of their sums", "[base]") {
    const double from[4][4] = {{1, 2, 3, 0}, {10, 20, 30, 0}, {4, 5, 6, 0}, {-7, 8, 9, 0}};
    Lanes row[4];
    for (int i = 0; i < 4; ++i) load(row[i], from[i]);
    const lanes::Vertices turned = lanes::transposed(row);
    const Lanes sums = lanes::row_sums(row[0], row[1], row[2], row[3]);
    for (int i = 0; i < 4; ++i) {
        CHECK(turned.x[i] == from[i][0]);
        CHECK(turned.y[i] == from[i][1]);
        CHECK(turned.z[i] == from[i][2]);
        CHECK(sums[i] == from[i][0] + from[i][1] + from[i][2]);
    }
    CHECK(lane_sum(sums) == 6 + 60 + 15 + 10);
}
