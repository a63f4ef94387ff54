#include "base/numbers.h"

#include <cmath>

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("numbers have three figures and a dash where not known", "[base]") {
    CHECK(figure(0.012345) == "0.0123");
    CHECK(figure(1.2345e-9) == "1.23e-09");
    CHECK(figure(std::nan("")) == "-");
}

TEST_CASE("lengths and times are in the largest unit that leaves one before the point", "[base]") {
    CHECK(length_text(1.5) == "1.5 m");
    CHECK(length_text(0.9996) == "1 m");
    CHECK(length_text(5.9e-4) == "590 µm");
    CHECK(time_text(8.3e-5) == "83 µs");
}
