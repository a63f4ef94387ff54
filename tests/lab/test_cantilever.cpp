// A strip of cloth as a textile laboratory bends it, and the elastica it should follow.
#include "lab/cantilever.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "lab/fit.h"
#include "support/meshes.h"

using namespace drape;

namespace {

Fabric bending(BendingKind kind, double load, const StripSize& size) {
    Fabric fabric;
    fabric.membrane = MembraneKind::stvk;
    fabric.membrane_poisson = fabric.poisson = 0;
    fabric.bending_kind = kind;
    fabric.bending = 1e-5;
    const double across = size.length * size.length;
    fabric.density = load * fabric.bending / (across * size.length * 9.81);
    fabric.stretch = 1e4 * std::max(10.0, load) * fabric.bending / across;
    return fabric;
}

}  // namespace

TEST_CASE("the heavy cantilever's tip hangs as tables of the elastica have it", "[lab]") {
    const double table[][2] = {{0.1, .012500}, {1, .124562},   {2, .246673},   {5, .585721},
                               {10, 1.066802}, {20, 1.863930}, {50, 3.705561}, {100, 5.888105}};
    for (const auto& [load, slope] : table) {
        CAPTURE(load);
        CHECK(heavy_cantilever(load).slope() == Approx(slope).epsilon(1e-5).margin(6e-7));  // as printed
    }
}

TEST_CASE("a clamped strip has its clamp at the middle of what is held on every mesh", "[lab]") {
    for (const char* name : {"alternating", "one_way", "equilateral", "pseudo_random", "adaptive"}) {
        CAPTURE(name);
        const StripSize size{0.2, 0.03, 16};
        const Mesh mesh = clamped_strip(name, size);
        const double held = -mesh.rest.row(0).minCoeff();
        CHECK(held > 0);
        int at_its_end = 0, between = 0;
        for (int v = 0; v < mesh.vertices(); ++v) {
            at_its_end += std::abs(mesh.rest(0, v) - held) < 1e-12;
            between += std::abs(mesh.rest(0, v)) < 0.999 * held;
        }
        CHECK(at_its_end >= 3);
        CHECK(between == 0);
        CHECK(mesh.rest.row(0).maxCoeff() == Approx(0.2));
    }
}

TEST_CASE("a strip of plates hangs as the elastica does on every mesh", "[lab]") {
    const StripSize size{0.2, 0.025, 32};
    for (const char* mesh : {"alternating", "one_way", "equilateral", "pseudo_random", "adaptive"}) {
        for (const double load : {1.0, 10.0}) {
            CAPTURE(mesh, load);
            const HangingTip tip =
                bend_strip(clamped_strip(mesh, size), bending(BendingKind::plate, load, size), 9.81);
            CHECK(tip.at_rest);
            // measured: within 0.06 %
            CHECK(tip.slope() == Approx(heavy_cantilever(load).slope()).epsilon(1e-3));
        }
    }
}

TEST_CASE("a fit gives a fabric whose virtual sheet and cantilever measure what was asked", "[lab]") {
    StretchCurve curve;
    for (const double strain : {0.01, 0.02, 0.05}) curve.samples.push_back({strain, 300 * strain});
    const FabricFit fit = fit_fabric(curve, 0.019, 0.15);
    CHECK(fit.modulus == Approx(300));
    CHECK(fit.off < 1e-12);
    CHECK(fit.virtual_modulus == Approx(300).epsilon(1e-6));
    CHECK(fit.virtual_length == Approx(0.019).epsilon(1e-3));
}

TEST_CASE("a stretch curve is read with its line of names, and what is wrong has its line", "[lab]") {
    const StretchCurve curve =
        parse_stretch_curve("strain,force\n# pulled slowly\n0,0\n0.01, 3\n\n0.02;6.5\r\n", "c.csv");
    REQUIRE(curve.samples.size() == 3);
    CHECK(curve.samples[2] == std::array{0.02, 6.5});
    const auto trouble = [](const char* text) {
        return error_of([&] { parse_stretch_curve(text, "c.csv"); });
    };
    CHECK(trouble("0,0\n0.01,x\n").starts_with("c.csv:2: expected \"strain,force per width\""));
    CHECK(trouble("0.01,1\n0.02,-1\n").starts_with("c.csv:2: strain and force"));
    CHECK(trouble("0,0\n0.01,1\n") ==
          "c.csv: a stretch curve needs two samples with strain and force over 0");
    CHECK(trouble("").starts_with("c.csv: a stretch curve needs"));
    CHECK_FALSE(trouble("0,0\n0.01,nan\n").empty());
}
