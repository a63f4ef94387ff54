#include "lab/compression.h"

#include <cmath>

#include <catch2/catch.hpp>

using namespace drape;

// Two springs c of length l from the held ends of a base of 1, apex at height y: force 2 c (l0 - l) y / l.
TEST_CASE("edge springs resist compression as two springs do", "[lab]") {
    const Fabric edges = compression_laws().front().fabric;
    const auto springs = [](double ratio) {
        const double y = ratio * std::sqrt(0.75), l = std::sqrt(0.25 + y * y);
        return (1 - l) * y / l;
    };
    const double scale = resistance_at(edges, 0.5) / springs(0.5);
    CHECK(scale > 0);
    for (const double ratio : {1.2, 0.9, 0.3, 0.01, -0.1, -0.2})
        CHECK(resistance_at(edges, ratio) == Approx(scale * springs(ratio)));
}

TEST_CASE("edges alone weaken to nothing at collapse and push an inverted triangle further", "[lab]") {
    const CompressionCurve edges = compression_curve(compression_laws().front());
    CHECK(edges.peak.ratio > 0.3);
    CHECK(edges.peak.ratio < 0.7);
    CHECK(edges.at_collapse < 1e-4 * edges.peak.force);
    CHECK(edges.inverted < -0.1 * edges.peak.force);
}

TEST_CASE("every law starts from rest without force and is odd in the height", "[lab]") {
    for (const Law& law : compression_laws()) {
        CAPTURE(law.name);
        CHECK(std::abs(resistance_at(law.fabric, 1)) < 1e-12);
        CHECK(resistance_at(law.fabric, 1.1) < 0);
        CHECK(resistance_at(law.fabric, 0.6) > 0);
        for (const double ratio : {0.9, 0.4, 0.05})
            CHECK(resistance_at(law.fabric, -ratio) == Approx(-resistance_at(law.fabric, ratio)));
    }
}

TEST_CASE("altitude springs still push at collapse and make it dearer", "[lab]") {
    const std::vector<Law> laws = compression_laws();
    const CompressionCurve edges = compression_curve(laws.front());
    for (size_t i = 1; i < laws.size(); ++i) {
        if (laws[i].fabric.altitude == AltitudeMode::none) continue;
        const CompressionCurve curve = compression_curve(laws[i]);
        CAPTURE(curve.law);
        CHECK(curve.at_collapse > 0.05);
        CHECK(curve.barrier > edges.barrier);
    }
}
