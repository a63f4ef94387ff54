// Labels find room beside their dots.
#include <catch2/catch.hpp>

#include "study/plot_labels.h"

using namespace drape;

TEST_CASE("a label covers no dot, no line, no other label, and stays inside", "[study]") {
    PlotLabels labels({0, 0}, {200, 200});
    const Pixel half(20, 6);
    std::vector<LabelBox> placed;
    for (int i = 0; i < 12; ++i) {
        const Pixel dot(15 + 15 * i, 20 + 14 * i);
        labels.keep_free(LabelBox{dot, {4, 4}});
        labels.keep_free(dot, dot + Pixel(15, 14));
    }
    for (int i = 0; i < 12; ++i) {
        const Pixel dot(15 + 15 * i, 20 + 14 * i);
        const auto centre = labels.place(dot, half);
        if (!centre) continue;
        const LabelBox box{*centre, half};
        CHECK(centre->x() - half.x() >= 0);
        CHECK(centre->x() + half.x() <= 200);
        CHECK_FALSE(box.meets(dot, dot + Pixel(15, 14)));
        for (const LabelBox& other : placed) CHECK_FALSE(box.meets(other));
        placed.push_back(box);
    }
    CHECK(placed.size() >= 6);
}

TEST_CASE("a segment meets a box only where it crosses it", "[study]") {
    const LabelBox box{{10, 10}, {5, 2}};
    CHECK(box.meets(Pixel(0, 10), Pixel(20, 10)));
    CHECK(box.meets(Pixel(10, 0), Pixel(10, 20)));
    CHECK_FALSE(box.meets(Pixel(0, 13), Pixel(20, 13)));
    CHECK_FALSE(box.meets(Pixel(0, 10), Pixel(4, 10)));
}
