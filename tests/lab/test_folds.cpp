#include "lab/folds.h"

#include <numeric>

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("a buckled disc of alternating diagonals folds along its lines and a random one wherever",
          "[lab]") {
    const FoldRose lined = fold_directions("alternating", 12, 1),
                   random = fold_directions("pseudo_random", 12, 1);
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
