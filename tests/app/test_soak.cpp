// Random scenes end finite and bounded, or are refused or stopped in one line.
#include <sys/resource.h>

#include <cstdlib>

#include <catch2/catch.hpp>

#include "app/random_scene.h"
#include "app/small_drop.h"
#include "io/cache_reader.h"
#include "support/run_program.h"

using namespace drape;
using namespace drape::test;

namespace {

constexpr int most_seconds = 120;  // CPU, of a scene
constexpr double far_away = 1e4;   // [m]

// Exit code of the scene's run, which is checked.
int soak(std::uint64_t seed) {
    const TemporaryFolder folder;
    const std::string text = random_scene(seed), out = folder.file("out");
    const Ran ran = run_drape_within(RLIMIT_CPU, most_seconds,
                                     {"simulate", folder.file("s.toml", text), "--out", out, "--quiet",
                                      "--threads", "1", "--cache", folder.file("out/c.pc2")});
    CAPTURE(seed, text, ran.exit_code, ran.err);
    CHECK((ran.exit_code == 0 || ran.exit_code == 2 || ran.exit_code == 4));
    CHECK(ran.error_lines() == (ran.exit_code == 0 ? 0 : 1));
    if (ran.exit_code != 0 && ran.exit_code != 4) return ran.exit_code;
    const Json report = report_of(out);
    for (const Json& frame : report["frames"]) {
        CHECK(frame["fastest_m_per_s"].is_number());
        CHECK(frame["largest_strain"].is_number());
    }
    for (const auto& entry : std::filesystem::directory_iterator(out)) {
        if (entry.path().extension() != ".pc2") continue;
        const Cache cache = read_cache(entry.path().string());
        CHECK(cache.samples.size() == report["frames"].size() + 1);
        for (const Points& sample : cache.samples) {
            REQUIRE(sample.allFinite());
            CHECK(sample.cwiseAbs().maxCoeff() < far_away);
        }
    }
    return ran.exit_code;
}

std::uint64_t number(const char* variable, std::uint64_t otherwise) {
    const char* text = std::getenv(variable);
    return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

}  // namespace

TEST_CASE("a few random scenes run or are refused", "[app]") {
    for (const std::uint64_t seed : {1, 2, 3}) soak(seed);
}

// By hand: test_app "[.soak]" runs DRAPE_SOAK_SCENES (1000) scenes from DRAPE_SOAK_SEED (1) on.
TEST_CASE("a thousand random scenes run or are refused or stop", "[.soak]") {
    const std::uint64_t first = number("DRAPE_SOAK_SEED", 1), scenes = number("DRAPE_SOAK_SCENES", 1000);
    int ran = 0, refused = 0, stopped = 0;
    for (std::uint64_t seed = first; seed < first + scenes; ++seed) {
        const int code = soak(seed);
        ran += code == 0;
        refused += code == 2;
        stopped += code == 4;
    }
    WARN(ran << " ran, " << refused << " were refused, " << stopped << " stopped, of " << scenes);
    CHECK(ran > refused + stopped);
}
