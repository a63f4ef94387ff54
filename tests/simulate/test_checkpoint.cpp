#include "simulate/checkpoint.h"

#include <catch2/catch.hpp>
#include <cstring>

#include "base/hash.h"
#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

Checkpoint small_checkpoint() {
    ByteWriter passes;
    passes.put(random_points(3, 1, 1));
    passes.put(7);
    Checkpoint checkpoint;
    checkpoint.scene = "schema = 1\n";
    checkpoint.steps = "verlet 3 4";
    checkpoint.start_energy = 1.75;
    checkpoint.solver.factorisations = 2;
    checkpoint.frames.resize(1);
    checkpoint.frames[0].crossings = 5;
    checkpoint.frames[0].error_max = 1e-3;
    checkpoint.frames[0].hash = "00ff";
    checkpoint.pictures = {"12ab"};
    checkpoint.keeps_positions = true;
    checkpoint.passes = std::move(passes).bytes();
    return checkpoint;
}

// The run that goes on from the bytes of `at` in a simulation of its own.
std::unique_ptr<Simulation> resumed(const Setup& setup, const std::string& bytes) {
    auto simulation = std::make_unique<Simulation>(setup);
    ByteReader in(bytes);
    REQUIRE(simulation->restore(in));
    CHECK(in.at_end());
    return simulation;
}

std::string bytes_of(const Simulation& simulation) {
    ByteWriter out;
    simulation.save(out);
    return std::move(out).bytes();
}

}  // namespace

TEST_CASE("a checkpoint's bytes give back every bit of it", "[simulate]") {
    const Checkpoint written = small_checkpoint();
    const auto read = read_checkpoint(checkpoint_bytes(written));
    REQUIRE(read);
    CHECK(read->scene == written.scene);
    CHECK(read->steps == written.steps);
    CHECK(read->solver.factorisations == 2);
    REQUIRE(read->frames.size() == 1);
    CHECK(read->frames[0].crossings == 5);
    CHECK(read->frames[0].error_max == 1e-3);
    CHECK(read->frames[0].hash == "00ff");
    CHECK(read->pictures == written.pictures);
    CHECK(read->keeps_positions);
    CHECK(read->start_energy == written.start_energy);
    CHECK(read->passes == written.passes);
    ByteReader in(read->passes);
    CHECK(in.take_points() == random_points(3, 1, 1));
    CHECK(in.take<int>() == 7);
    CHECK(in.at_end());
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

TEST_CASE("bytes that declare more points or text than they hold are refused", "[simulate]") {
    ByteWriter out;
    out.put(random_points(3, 1, 1));
    std::string whole = std::move(out).bytes();
    // the last one's 24 bytes a vertex wrap round to 72
    for (const std::uint64_t declared :
         {std::uint64_t{4}, std::uint64_t{1} << 60, (std::uint64_t{1} << 61) + 3}) {
        std::memcpy(whole.data(), &declared, sizeof declared);
        CAPTURE(declared);
        ByteReader points(whole), text(whole);
        CHECK(points.take_points().cols() == 0);
        CHECK_FALSE(points.ok());
        CHECK(points.take<int>() == 0);
        if (declared > whole.size()) CHECK(text.take_text().empty());
        if (declared > whole.size()) CHECK_FALSE(text.at_end());
    }
}

TEST_CASE("a state of another cloth is refused", "[simulate]") {
    const std::string bytes = bytes_of(Simulation(swatch(4, 200)));
    Simulation other(swatch(5, 200));
    ByteReader in(bytes);
    CHECK_FALSE(other.restore(in));
    CHECK(other.frame() == 0);
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
            checkpoints.push_back(bytes_of(whole));
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

TEST_CASE("a frame of any method follows from its start alone, through contact too", "[simulate]") {
    for (const Method& method : methods()) {
        Setup setup = ball_drop(6);
        if (method.conservative_only()) setup = swatch(6, 200);
        setup.method = method.name;
        if (method.is_implicit()) setup.step = 1 / 120.0;
        Simulation whole(setup);
        for (int frame = 0; frame < 6; ++frame) REQUIRE(whole.advance().trouble.empty());
        const auto other = resumed(setup, bytes_of(whole));
        const FrameReport report = whole.advance();
        CAPTURE(method.name);
        CHECK((method.conservative_only() || report.contacts > 0));
        CHECK(other->advance().hash == report.hash);
    }
}
