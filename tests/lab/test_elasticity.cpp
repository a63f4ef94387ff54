// The virtual tests against plane elasticity worked out by hand.
#include "lab/elasticity.h"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "lab/anisotropy.h"
#include "mesh/pattern.h"
#include "support/cloths.h"

using namespace drape;
using namespace drape::test;

namespace {

Mesh sheet(std::string_view pattern, int divisions, std::uint64_t seed = 1) {
    return make_pattern(pattern, {1, 1, divisions, divisions, seed});
}

Fabric edges(StretchModel model, double stretch) {
    Fabric fabric;
    fabric.stretch_model = model;
    fabric.stretch = stretch;
    return fabric;
}

}  // namespace

// Springs of constant c along both sides and one diagonal of squares of side d. Of each square they store
// c d^2 / 2 (exx^2 + eyy^2) and, on a diagonal of squared length 2 d^2, c d^2 ((exx + eyy + gxy) / 2)^2.
TEST_CASE("a grid cut one way has the elastic matrix of its springs", "[lab]") {
    const double c = 100;
    const Elasticity measured =
        measure_elasticity(sheet("one_way", 10), edges(StretchModel::spring_constant, c));
    // rising diagonals run along x against z or with it; shear couples by that sign
    const double sign = measured.stiffness(0, 2) > 0 ? 1 : -1;
    Mat3 expected;
    expected << 1.5, 0.5, sign * 0.5, 0.5, 1.5, sign * 0.5, sign * 0.5, sign * 0.5, 0.5;
    CAPTURE(measured.stiffness);
    CHECK((measured.stiffness - c * expected).norm() < 1e-5 * c);
}

// Equilateral triangles of springs c: E = 2 c / sqrt 3 and G = sqrt 3 / 4 c in every direction.
TEST_CASE("equilateral springs are alike in every direction", "[lab]") {
    const double c = 100;
    // as deep as twenty rows of them
    const Mesh mesh = make_pattern("equilateral", {1, std::sqrt(0.75), 20, 20});
    const Elasticity measured = measure_elasticity(mesh, edges(StretchModel::spring_constant, c));
    const DirectionCurve stretch = stretch_curve(measured), shear = shear_curve(measured);
    CHECK(stretch.angle_deg.size() == 60);
    CHECK(stretch.least == Approx(2 * c / std::sqrt(3)).epsilon(1e-5));
    CHECK(stretch.most == Approx(2 * c / std::sqrt(3)).epsilon(1e-5));
    CHECK(shear.least == Approx(std::sqrt(3) / 4 * c).epsilon(1e-5));
    CHECK(shear.ratio() == Approx(1).epsilon(1e-5));
}

TEST_CASE("finite elements have the fabric's moduli on every pattern", "[lab]") {
    Fabric fabric = edges(StretchModel::membrane, 80);
    fabric.membrane_poisson = 0.25;
    for (const PatternKind& pattern : pattern_kinds()) {
        for (const MembraneKind kind : {MembraneKind::stvk, MembraneKind::neo_hookean}) {
            fabric.membrane = kind;
            const Elasticity measured = measure_elasticity(sheet(pattern.name, 6), fabric);
            CAPTURE(pattern.name);
            CHECK(stretch_curve(measured).least == Approx(80).epsilon(1e-5));
            CHECK(stretch_curve(measured).ratio() == Approx(1).epsilon(1e-5));
            CHECK(shear_curve(measured).mean == Approx(80 / 2.5).epsilon(1e-5));
            CHECK(measured.stiffness(0, 1) == Approx(0.25 * measured.stiffness(0, 0)).epsilon(1e-5));
        }
    }
}

// The network's own modulus (`drape inspect`) moves every vertex with the strain: exact where that is how
// they rest, an upper bound elsewhere.
TEST_CASE("vertices that come to rest make irregular sheets softer and regular ones no softer", "[lab]") {
    const Fabric fabric = edges(StretchModel::membrane, 100);
    for (const char* pattern : {"one_way", "alternating", "crossed"}) {
        const Mesh mesh = sheet(pattern, 10);
        const DirectionalModulus affine = model_of(mesh, fabric).cloths[0].network.modulus;
        const DirectionCurve measured = stretch_curve(measure_elasticity(mesh, fabric));
        CAPTURE(pattern);
        CHECK(measured.least == Approx(affine.least).epsilon(1e-4));
        CHECK(measured.most == Approx(affine.most).epsilon(1e-4));
    }
    const DirectionCurve irregular = stretch_curve(measure_elasticity(sheet("pseudo_random", 24), fabric));
    CHECK(irregular.mean < 0.99 * fabric.stretch);
    CHECK(irregular.mean > 0.7 * fabric.stretch);
}

TEST_CASE("fine irregular sheets and equilateral ones are alike within a tenth by direction", "[lab]") {
    const std::vector<Law> kinds = stretch_laws();
    for (const Law& law : kinds) {
        CAPTURE(law.name);
        CHECK(pattern_stiffness("equilateral", law, 32, 1).stretch.ratio() < 1.02);
        CHECK(pattern_stiffness("pseudo_random", law, 48, 1).stretch.ratio() < 1.1);
    }
    CHECK(pattern_stiffness("one_way", kinds.front(), 12, 1).stretch.ratio() > 1.5);
}
