// The catalogue of extremes: every scene of assets/scenes/extreme comes to what its own [expect] says, and
// the README's table says the same.
#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "io/cache_reader.h"
#include "scene/read_parts.h"
#include "scene/reader.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;
using Json = nlohmann::json;

namespace {

std::vector<std::string> extreme_scenes() {
    std::vector<std::string> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(DRAPE_SOURCE_DIR "/assets/scenes/extreme"))
        scenes.push_back(entry.path().string());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

// read by itself: the rest of the file may be what is wrong
Expectation expected_of(const std::string& scene) {
    const Value root = parse_toml(bytes_of(scene), scene);
    const Value* expect = root.find("expect");
    REQUIRE(expect);
    return read_expect(*expect);
}

// every sample of every cache in the folder; returns how many there were
size_t check_caches(const std::string& folder) {
    size_t samples = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".pc2") continue;
        const Cache cache = read_cache(entry.path().string());
        for (const Points& sample : cache.samples) CHECK(sample.allFinite());
        samples = cache.samples.size();
    }
    return samples;
}

void check_frames(const Json& frames, double frame_rate, const Expectation& expected) {
    for (size_t k = 0; k < frames.size(); ++k) {
        const Json& frame = frames[k];
        CAPTURE(frame.dump());
        CHECK(frame["index"] == k + 1);
        CHECK(frame["time_s"].get<double>() == Approx(static_cast<double>(k + 1) / frame_rate));
        CHECK(frame["steps"].get<long>() > 0);
        REQUIRE(frame["largest_strain"].is_number());
        REQUIRE(frame["fastest_m_per_s"].is_number());
        CHECK(frame["largest_strain"].get<double>() <= expected.largest_strain.value_or(INFINITY));
        CHECK(frame["fastest_m_per_s"].get<double>() <= expected.fastest.value_or(INFINITY));
    }
}

}  // namespace

TEST_CASE("every extreme scene runs, is refused or stops as it says itself", "[app]") {
    for (const std::string& path : extreme_scenes()) {
        const Expectation expected = expected_of(path);
        const TemporaryFolder folder;
        const std::string out = folder.file("out");
        const Ran ran = run_drape({"simulate", path, "--out", out, "--no-estimate", "--quiet", "--cache",
                                   folder.file("out/frames.pc2")});
        CAPTURE(path, ran.err);
        if (expected.outcome == "refused") {
            CHECK(ran.exit_code == 2);
            CHECK(ran.error_lines() == 1);
            CHECK(ran.err.starts_with("drape: " + path + ":"));
            CHECK_THAT(ran.err, Catch::Contains(expected.because));
            CHECK_FALSE(std::filesystem::exists(out));
            continue;
        }
        const bool runs = expected.outcome == "runs";
        CHECK(ran.exit_code == (runs ? 0 : 4));
        CHECK(ran.error_lines() == (runs ? 0 : 1));
        CHECK_THAT(ran.err, Catch::Contains(expected.because));
        CHECK(std::filesystem::exists(out + "/checkpoint") == !runs);
        REQUIRE(std::filesystem::exists(out + "/report.json"));

        const SceneDescription scene = read_scene(path);
        const Json report = Json::parse(bytes_of(out + "/report.json"));
        const size_t frames = report["frames"].size();
        CHECK((frames == static_cast<size_t>(scene.frames())) == runs);
        CHECK(check_caches(out) == frames + 1);
        check_frames(report["frames"], scene.frame_rate, expected);
        CHECK(report["contact"]["deepest_penetration_m"] == 0);
        CHECK(report["energy"]["end_j"].is_number());
    }
}

TEST_CASE("the README lists every extreme scene with its outcome", "[app]") {
    const std::string readme = bytes_of(DRAPE_SOURCE_DIR "/README.md");
    for (const std::string& path : extreme_scenes())
        CHECK_THAT(readme, Catch::Contains("| `" + std::filesystem::path(path).stem().string() + "` | " +
                                           expected_of(path).outcome + " |"));
}
