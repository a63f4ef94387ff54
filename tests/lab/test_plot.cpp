#include "lab/plot.h"

#include <cmath>

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("a point that is not finite leaves a gap in a curve", "[lab]") {
    CHECK(data_block("c", {{0, 1}, {NAN, NAN}, {0.5, -2}}) == "$c << EOD\n0 1\n\n0.5 -2\nEOD\n");
}

TEST_CASE("panels and their margins fill the picture", "[lab]") {
    PanelGrid grid{2, 1, 300, 200};
    grid.left = 50, grid.right = 10, grid.top = 30, grid.bottom = 20, grid.across = 40;
    CHECK(grid.width() == 700);
    CHECK(grid.height() == 250);
}

TEST_CASE("the script draws every figure as svg and as png", "[lab]") {
    LabResult result;
    result.figures = {{"one", "", 300, 200, "$a << EOD\n1 1\nEOD\n", "plot $a\n"},
                      {"two", "", 300, 200, "", "plot x\n"}};
    const std::string script = lab_script({result});
    for (const char* name : {"'one.svg'", "'one.png'", "'two.svg'", "'two.png'"})
        CHECK_THAT(script, Catch::Contains(name));
    CHECK_THAT(script, Catch::Contains("size 300,200"));
}
