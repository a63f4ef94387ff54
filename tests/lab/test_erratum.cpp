#include "lab/erratum.h"

#include <cmath>

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("altitude forces shared as a lever keep a free triangle's energy and do not spin it", "[lab]") {
    for (const TriangleShape& shape : erratum_shapes()) {
        const FreeTriangle run = free_triangle(shape, FootSharing::lever, 0.1);
        CAPTURE(shape.name);
        CHECK(run.time.back() == Approx(0.1).margin(1e-3));
        for (size_t i = 0; i < run.time.size(); ++i) {
            CHECK(run.energy[i] == Approx(1).margin(0.01));
            CHECK(std::abs(run.momentum[i]) < 1e-9 * run.momentum_scale);
        }
    }
}

TEST_CASE("altitude forces shared as the notes print it make energy and spin from nothing", "[lab]") {
    const FreeTriangle run = free_triangle(erratum_shapes().front(), FootSharing::notes, 0.4);
    CHECK(run.energy.back() > 100);
    CHECK(run.time.back() < 0.4);
    CHECK(std::abs(run.momentum.back()) > run.momentum_scale);
}

TEST_CASE("only the lever's sharing does no work round a closed loop", "[lab]") {
    for (const TriangleShape& shape : erratum_shapes()) {
        CAPTURE(shape.name);
        CHECK(std::abs(work_round_loop(shape, FootSharing::lever)) < 1e-4);
    }
    CHECK(std::abs(work_round_loop(erratum_shapes().front(), FootSharing::notes)) > 0.01);
}
