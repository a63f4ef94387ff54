#include "simulate/checkpoint.h"

#include <catch2/catch.hpp>
#include <cstring>

#include "base/hash.h"
#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

Checkpoint small_checkpoint() {
    Checkpoint checkpoint;
    checkpoint.scene_hash = 0xfedcba9876543210;
    checkpoint.frame = 7;
    checkpoint.state = {random_points(3, 1, 1), random_points(3, 1, 2), 0.35};
    checkpoint.flow = {0.25, -0.5};
    checkpoint.start_energy = 1.75;
    return checkpoint;
}

// The run that goes on from the bytes of `at` in a simulation of its own.
std::unique_ptr<Simulation> resumed(const Setup& setup, const std::string& bytes) {
    const auto checkpoint = read_checkpoint(bytes);
    REQUIRE(checkpoint);
    auto simulation = std::make_unique<Simulation>(setup);
    simulation->resume(checkpoint->frame, checkpoint->state, checkpoint->flow);
    return simulation;
}

}  // namespace

TEST_CASE("a checkpoint's bytes give back every bit of it", "[simulate]") {
    const Checkpoint written = small_checkpoint();
    const auto read = read_checkpoint(checkpoint_bytes(written));
    REQUIRE(read);
    CHECK(read->scene_hash == written.scene_hash);
    CHECK(read->frame == written.frame);
    CHECK(read->state.x == written.state.x);
    CHECK(read->state.v == written.state.v);
    CHECK(read->state.time == written.state.time);
    CHECK(read->flow.dissipated == written.flow.dissipated);
    CHECK(read->flow.driven == written.flow.driven);
    CHECK(read->start_energy == written.start_energy);
}

TEST_CASE("a checkpoint cut short, lengthened or with any byte changed is refused", "[simulate]") {
    const std::string whole = checkpoint_bytes(small_checkpoint());
    for (size_t size = 0; size < whole.size(); ++size) {
        CAPTURE(size);
        CHECK_FALSE(read_checkpoint(whole.substr(0, size)));
        std::string changed = whole;
        changed[size] = static_cast<char>(changed[size] ^ 0x10);
        CHECK_FALSE(read_checkpoint(changed));
    }
    CHECK_FALSE(read_checkpoint(whole + '\0'));
    CHECK_FALSE(read_checkpoint(whole + whole));
}

TEST_CASE("a checkpoint that declares more vertices than it holds is refused, even when signed",
          "[simulate]") {
    const std::string whole = checkpoint_bytes(small_checkpoint());
    const size_t points = 6 * 3 * sizeof(double), hash = sizeof(std::uint64_t);
    const size_t count = whole.size() - hash - points - sizeof(std::uint64_t);
    // the last one's 24 bytes a vertex wrap round to 72
    for (const std::uint64_t declared :
         {std::uint64_t{2}, std::uint64_t{4}, std::uint64_t{1} << 60, (std::uint64_t{1} << 61) + 3}) {
        std::string forged = whole.substr(0, whole.size() - hash);
        std::memcpy(forged.data() + count, &declared, sizeof declared);
        const std::uint64_t signature = hash_bytes(forged.data(), forged.size());
        forged.append(reinterpret_cast<const char*>(&signature), sizeof signature);
        CAPTURE(declared);
        CHECK_FALSE(read_checkpoint(forged));
    }
}

TEST_CASE("a run resumed from any frame has the bits of a run never interrupted", "[simulate]") {
    struct Case {
        const char* what;
        Setup setup;
    };
    for (const Case& c : {Case{"swatch", swatch(8, 200)}, Case{"flag", flag()},
                          Case{"ball drop", ball_drop()}, Case{"near miss", near_miss()}}) {
        std::vector<std::string> checkpoints;
        std::vector<FrameReport> reports;
        Simulation whole(c.setup);
        while (whole.frame() < whole.frames()) {
            reports.push_back(whole.advance());
            REQUIRE(reports.back().trouble.empty());
            checkpoints.push_back(checkpoint_bytes({1, whole.frame(), whole.state(), whole.flow(), 0}));
        }
        for (size_t from = 0; from + 1 < checkpoints.size(); ++from) {
            const auto simulation = resumed(c.setup, checkpoints[from]);
            for (size_t frame = from + 1; frame < reports.size(); ++frame) {
                const FrameReport report = simulation->advance(), &expected = reports[frame];
                CAPTURE(c.what, from + 1, frame + 1);
                CHECK(report.hash == expected.hash);
                CHECK(report.index == expected.index);
                CHECK(report.steps == expected.steps);
                CHECK(report.shortest_step == expected.shortest_step);
                CHECK(report.contacts == expected.contacts);
                CHECK(report.least_distance == expected.least_distance);
            }
            CHECK(simulation->state().v == whole.state().v);
            CHECK(simulation->flow().dissipated == whole.flow().dissipated);
            CHECK(simulation->flow().driven == whole.flow().driven);
        }
    }
}
