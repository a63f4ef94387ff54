// The verb `video` as its users run it. What needs ffmpeg is skipped, with a warning, where it is not
// installed.
#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/ffmpeg.h"
#include "support/frames.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;
using Catch::Matchers::Contains;
using Json = nlohmann::json;

namespace {

// Writes a report of a run at 12 frames a second into `folder`.
void write_report(const std::string& folder) {
    write_file(folder + "/report.json",
               std::string("{\"scene\": \"disc\", \"method\": {\"name\": \"verlet\", \"step_s\": 1e-3}, "
                           "\"time\": {\"total_s\": 1}, "
                           "\"frames\": [{\"index\": 12, \"time_s\": 1.0, \"error_m\": null}]}"));
}

double seconds_of(const std::string& video) {
    const std::string says = probed(video);
    return std::stod(value_of(says.substr(says.find("[FORMAT]")), "duration"));
}

}  // namespace

TEST_CASE("a video plays at the rate its scene has, there and back, twice, at three times the speed",
          "[app]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    const std::string frames = write_frames(folder.file("a"), 12), out = folder.file("a.mp4");
    write_report(frames);
    const Ran ran = run_drape({"video", frames, "--out", out});
    CAPTURE(ran.err);
    REQUIRE(ran.exit_code == 0);
    CHECK_THAT(ran.out, Contains("12 frames of 64x36, 12 a second, 1 s"));
    CHECK(seconds_of(out) == Approx(1));
    REQUIRE(run_drape({"video", frames, "-o", out, "--boomerang", "--loop", "2", "--speed", "3", "--quiet"})
                .exit_code == 0);
    CHECK(value_of(probed(out), "nb_read_frames") == "44");
    CHECK(seconds_of(out) == Approx(44.0 / 36).margin(0.001));
    REQUIRE(run_drape({"video", frames, frames, "-o", out, "--fps", "24"}).exit_code == 0);
    CHECK(seconds_of(out) == Approx(1));
}

TEST_CASE("a video has its report's caption burnt in, or another, or none", "[app]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    const std::string frames = write_frames(folder.file("a"), 2, 320, 180), out = folder.file("a.mp4");
    write_report(frames);
    const auto corner = [&](const std::vector<std::string>& flags) {
        std::vector<std::string> words{"video", frames, "-o", out, "--quiet"};
        words.insert(words.end(), flags.begin(), flags.end());
        const Ran ran = run_drape(words);
        CHECK(ran.out + ran.err == "");
        REQUIRE(ran.exit_code == 0);
        const Image frame = decoded_frame(out, 0, 320, 180);
        double sum = 0;
        for (int y = 145; y < 175; ++y)
            for (int x = 0; x < 160; ++x) sum += frame.pixel(x, y)[0];
        return sum / (30 * 160);
    };
    const double plain = corner({"--no-caption"}), reported = corner({}), other = corner({"--caption", "x"});
    CHECK(plain == Approx(161).margin(3));  // the ground as it is
    CHECK(reported < plain - 20);
    CHECK(other < plain - 1);
    CHECK(other > reported + 10);
}

TEST_CASE("panes stand side by side with their difference", "[app]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    const std::string frames = write_frames(folder.file("a"), 2), out = folder.file("a.gif");
    REQUIRE(run_drape({"video", "--side-by-side", frames, frames, "--difference", "-o", out}).exit_code == 0);
    CHECK(value_of(probed(out), "width") == std::to_string(3 * 64 + 2 * 2));
    CHECK(value_of(probed(out), "height") == "36");
}

TEST_CASE("a video becomes as small as it is asked or is not made", "[app]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    const std::string frames = write_frames(folder.file("a"), 12, 320, 180), out = folder.file("a.webp");
    REQUIRE(run_drape({"video", frames, "-o", out}).exit_code == 0);
    const auto whole = std::filesystem::file_size(out);
    const double most = static_cast<double>(whole) / 2e6;
    REQUIRE(run_drape({"video", frames, "-o", out, "--at-most", std::to_string(most)}).exit_code == 0);
    CHECK(std::filesystem::file_size(out) <= whole / 2);
    std::filesystem::remove(out);
    const Ran ran = run_drape({"video", frames, "-o", out, "--at-most", "0.0001"});
    CHECK(ran.exit_code == 3);
    CHECK_THAT(ran.err, Contains("a.webp: cannot write: at its smallest it has"));
    CHECK(folder.files() == 1);
}

TEST_CASE("without ffmpeg a video is one line and exit 3", "[app]") {
    const TemporaryFolder folder;
    const std::string frames = write_frames(folder.file("a"), 2);
    const Environment path("PATH", "");
    const Ran ran = run_drape({"video", frames, "-o", folder.file("a.mp4")});
    CHECK(ran.exit_code == 3);
    CHECK(ran.err == "drape: " + folder.file("a.mp4") + ": cannot write: ffmpeg is not installed\n");
    CHECK(folder.files() == 1);
}

TEST_CASE("a rate that no player keeps is refused", "[app]") {
    const TemporaryFolder folder;
    const std::string frames = write_frames(folder.file("a"), 2);
    for (const std::string rate : {"1e-300", "1e300"}) {
        const Ran ran = run_drape({"video", frames, "-o", folder.file("a.mp4"), "--fps", rate});
        CHECK(ran.exit_code == 2);
        CHECK_THAT(ran.err, Contains("frames a second (--fps times --speed: 0.01 to 100000)"));
    }
    CHECK(folder.files() == 1);
}

TEST_CASE("sequences of other rates play together only at a rate that is given", "[app]") {
    const TemporaryFolder folder;
    const std::string a = write_frames(folder.file("a"), 2), b = write_frames(folder.file("b"), 2);
    write_report(a);
    write_file(b + "/report.json",
               std::string("{\"scene\": \"b\", \"method\": {\"name\": \"verlet\", \"step_s\": 1}, "
                           "\"time\": {\"total_s\": 1}, "
                           "\"frames\": [{\"index\": 1, \"time_s\": 0.04, \"error_m\": 1}]}"));
    const Ran ran = run_drape({"video", a, b, "-o", folder.file("a.mp4")});
    CHECK(ran.exit_code == 2);
    CHECK(ran.error_lines() == 1);
    CHECK_THAT(ran.err, Contains("b: is of 25 frames a second") && Contains("a of 12 (--fps"));
    CHECK(folder.files() == 2);
}

TEST_CASE("a video that is interrupted leaves nothing", "[app]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    const std::string frames = write_frames(folder.file("a"), 2), out = folder.file("a.mp4");
    CHECK(interrupted_drape({"video", frames, "-o", out, "--loop", "1000", "--quiet"},
                            [&] { return folder.files() > 1; }) == 130);
    CHECK(folder.files() == 1);
}

#ifdef DRAPE_WITH_RENDER

namespace {

// A small sheet falls; ten frames a second.
std::string falling_sheet(const std::string& duration) {
    return "schema = 1\n[scene]\nduration = " + duration +
           "\nframe_rate = 10\n[[cloth]]\npattern = { name = \"alternating\", divisions = [6, 6] }\n"
           "fabric = \"cotton\"\n[render]\nsize = [97, 61]\n"
           "camera = { from = [1, 1, 2], at = [0, -0.2, 0], fov_deg = 45 }\n";
}

}  // namespace

TEST_CASE("render makes the very video that its pictures make, however many threads draw", "[app]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    const std::string scene = folder.file("sheet.toml", falling_sheet("0.8")), out = folder.file("out");
    for (const std::string name : {"a.mp4", "a.gif"}) {
        const std::string video = folder.file("videos/" + name), after = folder.file(name);
        const Ran ran = run_drape({"render", scene, "--out", out, "--video", video, "--threads", "3",
                                   "--no-estimate", "--frames", "2:7"});
        CAPTURE(name, ran.err);
        REQUIRE(ran.exit_code == 0);
        CHECK_THAT(ran.out, Contains(video));
        const Json time = Json::parse(bytes_of(out + "/report.json"))["time"];
        CHECK(time["video_s"].get<double>() > 0);
        CHECK(time["total_s"].get<double>() > time["video_s"].get<double>() + time["render_s"].get<double>());
        REQUIRE(run_drape({"video", out, "-o", after, "--no-caption"}).exit_code == 0);
        CHECK(value_of(probed(video), "nb_read_frames") == "6");
        CHECK(bytes_of(video) == bytes_of(after));
    }
}

TEST_CASE("the video of a run that was stopped and resumed has every frame", "[app]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    const std::string scene = folder.file("sheet.toml", falling_sheet("6")), out = folder.file("out"),
                      video = folder.file("a.mp4"), after = folder.file("b.mp4");
    REQUIRE(interrupted_drape({"render", scene, "--out", out, "--video", video, "--quiet"},
                              [&] { return std::filesystem::exists(out + "/frame_0003.png"); }) == 130);
    CHECK(folder.files() == 2);  // scene and results: no video of a part
    const Ran ran = run_drape({"render", scene, "--out", out, "--video", video, "--resume", "--quiet"});
    CAPTURE(ran.err);
    REQUIRE(ran.exit_code == 0);
    REQUIRE(run_drape({"video", out, "-o", after, "--no-caption"}).exit_code == 0);
    CHECK(value_of(probed(video), "nb_read_frames") == "60");
    CHECK(bytes_of(video) == bytes_of(after));
}

TEST_CASE("a video that cannot be made is told before anything is simulated", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("sheet.toml", falling_sheet("0.8")), out = folder.file("out");
    const Ran wrong = run_drape({"render", scene, "--out", out, "--video", folder.file("a.avi")});
    CHECK(wrong.exit_code == 2);
    CHECK_THAT(wrong.err, Contains("(known: .mp4, .webm, .webp, .gif)"));
    const Environment path("PATH", "");
    const Ran missing = run_drape({"render", scene, "--out", out, "--video", folder.file("a.mp4")});
    CHECK(missing.exit_code == 3);
    CHECK(missing.err == "drape: " + folder.file("a.mp4") + ": cannot write: ffmpeg is not installed\n");
    CHECK(folder.files() == 1);
}

#endif
