// The drape test: a disc over a support, and its shadow.
#include "lab/cusick.h"

#include <catch2/catch.hpp>

#include "lab/fabrics.h"
#include "mesh/pattern.h"
#include "support/meshes.h"

using namespace drape;

TEST_CASE("a shadow counts what is covered once, however it lies", "[lab]") {
    const Mesh sheet = make_pattern("alternating", {0.2, 0.1, 4, 2});
    CHECK(shadow_area(sheet.faces, sheet.rest, 5e-4) == Approx(0.02).epsilon(0.01));
    Points folded = sheet.rest;
    folded.row(0) = folded.row(0).cwiseAbs();
    CHECK(shadow_area(sheet.faces, folded, 5e-4) == Approx(0.01).epsilon(0.01));
    Points upright = sheet.rest;
    upright.row(1) = upright.row(0);
    upright.row(0) *= 0;
    CHECK(shadow_area(sheet.faces, upright, 5e-4) < 1e-4);
}

TEST_CASE("stiff cloth keeps its disc, and what bends more easily drapes more", "[lab]") {
    const double edge = 0.016;
    CHECK(drape_disc(fabric_preset("paper"), edge).coefficient > 0.98);
    const CusickDrape denim = drape_disc(fabric_preset("denim"), edge),
                      silk = drape_disc(fabric_preset("silk"), edge);
    CHECK(denim.at_rest);
    CHECK(silk.at_rest);
    CHECK(silk.coefficient > 0.15);
    CHECK(denim.coefficient > silk.coefficient + 0.15);
    CHECK(denim.coefficient < 0.95);
}

TEST_CASE("the laboratory measures the fabrics it is asked for", "[lab]") {
    const LabResult result = measure_fabrics(std::vector<std::string>{"paper"});
    CHECK(result.claim.starts_with("drape coefficients: paper "));
    CHECK(result.tables.front().rows.size() == 1);
    CHECK(result.csv.front().file == "fabric");
    CHECK_THAT(error_of([] { measure_fabrics(std::vector<std::string>{"papr"}); }),
               Catch::Contains("\"paper\""));
}
