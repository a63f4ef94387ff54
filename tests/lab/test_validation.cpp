// The problems with an analytic answer, measured: what must pass.
#include "lab/validation.h"

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("a check passes within its tolerance, which is absolute where nothing is expected", "[lab]") {
    CHECK(Check{"", "", 100, 100.9, 0.01, ""}.passes());
    CHECK_FALSE(Check{"", "", 100, 98.9, 0.01, ""}.passes());
    CHECK(Check{"", "", 0, 0.9, 1, ""}.passes());
    CHECK_FALSE(Check{"", "", 0, 1.1, 1, ""}.passes());
}

TEST_CASE("a curtain swings with the frequencies of a hanging chain", "[lab]") {
    for (const Check& check : check_curtain(20)) {
        CAPTURE(check.problem, check.measured, check.off());
        CHECK(std::abs(check.off()) < 0.04);  // measured, 40 rows: 0.02, 0.24 and 0.97 %
        CHECK(check.off() < 0);               // a chain of lumps is slower, the finer the less
    }
}

TEST_CASE("a strip of finite elements hangs by its closed form and one of springs does not", "[lab]") {
    Fabric fabric;
    fabric.density = 0.2;
    fabric.stretch = 1e4;
    const Check springs = check_strip("springs", fabric, 30);
    fabric.membrane = MembraneKind::stvk;
    const Check elements = check_strip("elements", fabric, 30);
    CHECK(elements.passes());
    CHECK(springs.off() == Approx(-0.19).margin(0.02));
}

TEST_CASE("a sheet holds below its friction angle and slides by Coulomb's law above", "[lab]") {
    for (const Check& check : check_slope()) {
        CAPTURE(check.problem, check.measured);
        CHECK(check.passes());
    }
}
