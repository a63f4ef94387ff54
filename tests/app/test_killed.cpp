// Runs that are killed at any instant, and end as if they had not been.
#include <chrono>
#include <cstdlib>
#include <random>

#include <catch2/catch.hpp>

#include "app/small_drop.h"
#include "support/run_program.h"

using namespace drape;
using namespace drape::test;

namespace {

#ifdef DRAPE_WITH_RENDER
constexpr const char* verb = "render";
#else
constexpr const char* verb = "simulate";
#endif

// A run and what it is to leave: one that nothing stops goes to "whole", its copy with kills to "cut".
struct Killed {
    TemporaryFolder folder;
    std::string scene;
    std::vector<std::string> more;

    Killed(const std::string& duration, std::vector<std::string> options)
        : scene(folder.file("drop.toml", small_drop(duration))), more(std::move(options)) {
        const Ran ran = run_drape(command("whole"));
        CAPTURE(ran.err);
        REQUIRE(ran.exit_code == 0);
    }
    std::vector<std::string> command(const std::string& out, bool resume = false) const {
        std::vector<std::string> words{verb,
                                       scene,
                                       "--out",
                                       folder.file(out),
                                       "--checkpoint-every",
                                       "0",
                                       "--quiet",
                                       "--cache",
                                       folder.file(out) + "/cache.pc2"};
        words.insert(words.end(), more.begin(), more.end());
        if (resume) words.push_back("--resume");
        return words;
    }
    bool kill_at(const std::function<bool()>& sign) const {
        return interrupted_drape(command("cut", true), sign, SIGKILL) == -SIGKILL;
    }
    // of the frames that a checkpoint counts
    size_t kept() const {
        std::error_code none;
        const auto bytes = std::filesystem::file_size(folder.file("cut/positions"), none);
        return none ? 0 : static_cast<size_t>(bytes) / (13 * 13 * 3 * sizeof(double));
    }
    void finish_and_compare() const {
        const Ran ran = run_drape(command("cut", true));
        CAPTURE(ran.err);
        REQUIRE(ran.exit_code == 0);
        Json whole = report_of(folder.file("whole")), cut = report_of(folder.file("cut"));
        for (Json* report : {&whole, &cut}) {
            for (const char* key : {"time", "memory_peak_mb", "notes"}) report->erase(key);
            (*report)["error"].erase("passes");
            (*report)["machine"].erase("renderer");
            (*report)["plan"].erase("used");
        }
        CHECK(cut == whole);
        size_t files = 0;
        for (const auto& entry : std::filesystem::directory_iterator(folder.file("whole"))) {
            const std::string name = entry.path().filename();
            CAPTURE(name);
            if (name != "report.json") CHECK(bytes_of(folder.file("cut/" + name)) == bytes_of(entry.path()));
            ++files;
        }
        const std::filesystem::directory_iterator left(folder.file("cut"));
        CHECK(static_cast<size_t>(std::distance(begin(left), end(left))) == files);
    }
};

}  // namespace

TEST_CASE("a run killed at several instants and resumed leaves what one never stopped leaves", "[app]") {
    const Killed run("2", {});
    int kills = 0;
    for (const size_t frame : {1U, 6U, 7U, 15U}) kills += run.kill_at([&] { return run.kept() > frame; });
    CHECK(kills == 4);
    REQUIRE(std::filesystem::exists(run.folder.file("cut/checkpoint")));
    run.finish_and_compare();
}

// By hand, some minutes: test_app "[.kills]"
TEST_CASE("a run of 60 frames killed 30 times at random instants leaves what one never stopped leaves",
          "[.kills]") {
    const Killed run("6", {});
    std::mt19937 dice(std::random_device{}());
    int kills = 0;
    while (kills < 30) {
        using Clock = std::chrono::steady_clock;
        // long enough to come as far as a frame, now and then
        const auto until =
            Clock::now() + std::chrono::milliseconds(std::uniform_int_distribution(1, 1000)(dice));
        if (!run.kill_at([&] { return Clock::now() > until; })) {
            // it was done before: again from the start
            std::filesystem::remove_all(run.folder.file("cut"));
            continue;
        }
        ++kills;
    }
    run.finish_and_compare();
}

TEST_CASE("a run to a tolerance killed in any pass leaves what one never stopped leaves", "[app]") {
    const Killed run("0.6", {"--tolerance", "1e-2"});
    int kills = 0;
    for (const int times : {1, 3, 9}) {
        std::filesystem::file_time_type last;
        int seen = 0;
        kills += run.kill_at([&] {
            std::error_code none;
            const auto written = std::filesystem::last_write_time(run.folder.file("cut/checkpoint"), none);
            if (!none && written != last) ++seen;
            last = written;
            return seen > times;
        });
    }
    CHECK(kills > 0);
    run.finish_and_compare();
}

TEST_CASE("resuming with a changed scene names the keys and goes on from a frame only if asked to", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop("3")), out = folder.file("out");
    REQUIRE(interrupted_drape({"simulate", scene, "--out", out, "--quiet"},
                              [&] { return std::filesystem::exists(out); }) == 130);
    const std::string frame = std::to_string(report_of(out)["frames"].size());
    const auto resume = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"simulate", scene, "--out", out, "--quiet"});
        return run_drape(more);
    };
    const auto refused = [&](const std::vector<std::string>& more, const std::string& says) {
        const Ran ran = resume(more);
        CAPTURE(ran.err);
        CHECK(ran.exit_code == 2);
        CHECK(ran.error_lines() == 1);
        CHECK_THAT(ran.err, Catch::Contains(says));
    };
    const std::vector<std::string> rougher{"--set", "obstacle.0.friction=0.7", "--set",
                                           "cloth.0.fabric={ preset = \"cotton\", damping = 0.02 }"};
    std::vector<std::string> more = rougher;
    more.push_back("--resume");
    refused(more, "is of a run with another cloth.0.fabric.damping, obstacle.0.friction (--from " + frame);
    refused({"--resume", "--set", "cloth.0.pattern.divisions=[8, 8]"}, "cloth.0.pattern.divisions");
    refused({"--from", frame, "--set", "scene.frame_rate=20"},
            "another scene.frame_rate, which holds for all");
    refused({"--from", frame, "--set", "cloth.0.pattern.divisions=[8, 8]"}, "another mesh");
    refused({"--from", "29"}, "is of frame " + frame);
    refused({"--resume", "--cache", folder.file("c.pc2")}, "a run without a --cache");

    more = rougher;
    more.insert(more.end(), {"--from", frame});
    const Ran ran = resume(more);
    CAPTURE(ran.err);
    REQUIRE(ran.exit_code == 0);
    const Json report = report_of(out);
    CHECK(report["frames"].size() == 30);
    CHECK_THAT(report["notes"].dump(),
               Catch::Contains("frames 1 to " + frame + " are of a run with another cloth.0.fabric.damping"));
    refused({"--from", "3"}, "checkpoint: no such file");
}

TEST_CASE("a fresh run leaves nothing of an earlier one to be resumed", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop("3")), out = folder.file("out");
    REQUIRE(interrupted_drape({"simulate", scene, "--out", out, "--quiet"},
                              [&] { return std::filesystem::exists(out); }) == 130);
    // killed before its first checkpoint
    REQUIRE(interrupted_drape(
                {"simulate", scene, "--out", out, "--quiet", "--checkpoint-every", "1000"},
                [&] { return !std::filesystem::exists(out + "/checkpoint"); }, SIGKILL) == -SIGKILL);
    CHECK_FALSE(std::filesystem::exists(out + "/checkpoint"));
}
