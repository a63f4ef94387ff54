#include "lab/folds.h"

#include <numeric>

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("a buckled disc of one-way diagonals folds in some directions more than a random one does",
          "[lab]") {
    const FoldRose lined = fold_directions("one_way", 14, 1),
                   random = fold_directions("pseudo_random", 14, 1);
    for (const FoldRose& rose : {lined, random}) {
        CAPTURE(rose.pattern);
        CHECK(rose.share.size() == fold_bins);
        CHECK(std::accumulate(rose.share.begin(), rose.share.end(), 0.0) == Approx(fold_bins));
        CHECK(rose.most() >= 1);
        CHECK(rose.turn_deg > 0);
        CHECK(rose.turn_deg < 45);
    }
    CHECK(lined.most() > random.most());
}
