#include "lab/squeeze.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "lab/compression.h"

using namespace drape;

namespace {

SqueezeCurve of(std::string_view name) {
    for (const Law& law : compression_laws())
        if (law.name == name) return squeeze_curve(law, 4, 0.3);
    throw Error("no such law");
}

}  // namespace

TEST_CASE("a sheet resists a small squeeze as its stiffness says and then as its law does", "[lab]") {
    const SqueezeCurve edges = of("edges alone"), all = of("altitudes: all"), blend = of("altitudes: blend");
    for (const SqueezeCurve& curve : {edges, all, blend}) {
        CAPTURE(curve.law);
        REQUIRE(curve.samples.size() == 15);
        CHECK(std::abs(curve.samples[0].force) < 1e-6);
        CHECK(curve.samples[1].force == Approx(0.05).epsilon(0.5));
        CHECK(curve.samples[0].inverted == 0);
    }
    // edges give way: less force at 0.3 than before, and less than any altitudes leave
    CHECK(edges.samples.back().force < edges.peak.force);
    CHECK(edges.samples.back().force < all.samples.back().force);
    CHECK(edges.samples.back().force < blend.samples.back().force);
    CHECK(edges.first_inverted >= blend.first_inverted);
}
