#include "video/effort.h"

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("each effort asks for less than the one before and what is far too large leaves several out",
          "[video]") {
    for (std::size_t i = 1; i < efforts().size(); ++i) CHECK(efforts()[i].share < efforts()[i - 1].share);
    CHECK(next_effort(0, 1100, 1000) == 1);
    const std::size_t far = next_effort(0, 10000, 1000);
    CHECK(far > 3);
    CHECK(efforts()[far].share <= 0.11);
    CHECK(efforts()[far - 1].share > 0.11);
    // the smallest is tried whatever is asked, and nothing comes after it
    CHECK(next_effort(0, 1000000, 1) == efforts().size() - 1);
    CHECK(next_effort(efforts().size() - 1, 1000000, 1) == efforts().size());
}
