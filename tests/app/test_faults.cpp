// What the machine refuses: one line, the right exit code, nothing half-written, and what was good is kept.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include <catch2/catch.hpp>

#include "app/small_drop.h"
#include "support/ffmpeg.h"
#include "support/run_program.h"

using namespace drape;
using namespace drape::test;

namespace {

#ifdef DRAPE_WITH_RENDER
constexpr const char* verb = "render";
#else
constexpr const char* verb = "simulate";
#endif

// Nothing under a temporary name.
void check_nothing_half_written(const std::string& folder) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().filename();
        CHECK_THAT(name, !Catch::Contains(".part"));
    }
}

void fails(const Ran& ran, int exit_code, const std::string& says) {
    CAPTURE(ran.err);
    CHECK(ran.exit_code == exit_code);
    CHECK(ran.error_lines() == 1);
    CHECK_THAT(ran.err, Catch::Contains(says));
}

}  // namespace

TEST_CASE("a file size limit ends a run with exit 3 wherever it is met", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop()), cache = folder.file("c.pc2");
    // a cache outgrows it, the report, the first picture
    fails(run_drape_within(RLIMIT_FSIZE, 6000,
                           {"simulate", scene, "--quiet", "--out", folder.file("a"), "--cache", cache}),
          3, "cannot write: File too large");
    CHECK_FALSE(std::filesystem::exists(cache));
    fails(run_drape_within(RLIMIT_FSIZE, 100, {verb, scene, "--quiet", "--out", folder.file("b")}), 3,
          "cannot write: File too large");
    CHECK(std::filesystem::is_empty(folder.file("b")));
    check_nothing_half_written(folder.path());
}

TEST_CASE("a full disk ends a run with exit 3 and leaves what was whole", "[app]") {
    if (std::system("unshare -Urm true > /dev/null 2>&1") != 0) {
        WARN("skipped: no small file system can be mounted here");
        return;
    }
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop("3")), out = folder.file("out");
    std::filesystem::create_directory(out);
    const std::string command = std::string(DRAPE_PROGRAM) + " " + verb + " " + scene +
                                " --quiet --checkpoint-every 0 --cache " + out + "/c.pc2 --out " + out +
                                " 2> " + folder.file("err");
    const std::string script =
        folder.file("script", "mount -t tmpfs -o size=64k none " + out + " && " + command +
                                  "\ncode=$?\nls -A " + out + " > " + folder.file("left") + "\nexit $code\n");
    const int status = std::system(("unshare -Urm sh " + script).c_str());
    CHECK(WEXITSTATUS(status) == 3);
    const std::string err = bytes_of(folder.file("err")), left = bytes_of(folder.file("left"));
    CAPTURE(err, left);
    CHECK_THAT(err, Catch::EndsWith("cannot write: No space left on device\n"));
    CHECK(std::count(err.begin(), err.end(), '\n') == 1);
    CHECK_THAT(left, !Catch::Contains(".part") && !Catch::Contains("c.pc2") && Catch::Contains("checkpoint"));
}

TEST_CASE("a device where a result should go is refused and left alone", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop()), cache = folder.file("c.pc2");
    std::filesystem::create_symlink("/dev/full", cache);
    fails(run_drape({"simulate", scene, "--out", folder.file("out"), "--cache", cache}), 3,
          "c.pc2: cannot write: is not a regular file");
    CHECK(std::filesystem::is_symlink(cache));
}

TEST_CASE("a folder that may not be written to ends a run with exit 3 before anything is simulated",
          "[app]") {
    if (geteuid() == 0) {
        WARN("skipped: root may write anywhere");
        return;
    }
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop("100"));
    std::filesystem::create_directory(folder.file("locked"));
    std::filesystem::permissions(folder.file("locked"), std::filesystem::perms::owner_read);
    fails(run_drape({verb, scene, "--out", folder.file("locked/out")}), 3, "cannot make the folder");
    fails(run_drape({"simulate", scene, "--out", folder.file("out"), "--cache", folder.file("locked/c.pc2")}),
          3, "c.pc2: cannot write: Permission denied");
    std::filesystem::permissions(folder.file("locked"), std::filesystem::perms::owner_all);
}

TEST_CASE("a results folder removed during the run ends it with exit 3 and is not made again", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop("3")), out = folder.file("out");
    const int code =
        interrupted_drape({verb, scene, "--out", out, "--quiet", "--checkpoint-every", "0"}, [&] {
            if (!std::filesystem::exists(out + "/checkpoint")) return false;
            std::error_code busy;
            std::filesystem::remove_all(out, busy);
            return false;  // it ends by itself
        });
    CHECK(code == 3);
    CHECK_FALSE(std::filesystem::exists(out + "/report.json"));
}

TEST_CASE("a run that needs more memory than there is is refused with the figure", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop());
    const auto run = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {verb, scene, "--out", folder.file("out")});
        return run_drape(more);
    };
    // a million frames' positions of two passes
    fails(run({"--set", "scene.duration=1e5", "--set", "cloth.0.pattern.divisions=[300, 300]", "--tolerance",
               "1e-3"}),
          2, "needs about 4");
    CHECK(folder.files() == 1);
}

TEST_CASE("a scene's names lead to no other file", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop());
    const Ran ran =
        run_drape({"simulate", scene, "--out", folder.file("out"), "--quiet", "--set",
                   "scene.name=\"../../elsewhere/$(touch a)\"", "--cache", folder.file("out/c.pc2")},
                  folder.path());
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 0);
    CHECK(report_of(folder.file("out"))["scene"] == "../../elsewhere/$(touch a)");
    CHECK(folder.files() == 2);
    // no key of a scene says where anything goes
    for (const char* key : {"scene.out=a", "scene.cache=a", "render.video=a", "accuracy.replay=a"})
        fails(run_drape({"simulate", scene, "--out", folder.file("b"), "--set", key}), 2, "unknown ");
}

#ifndef DRAPE_SANITIZED  // whose shadow memory takes up more addresses than any limit leaves
TEST_CASE("memory that runs out all the same is an error", "[app]") {
    const TemporaryFolder folder;
    fails(run_drape_within(RLIMIT_AS, 200 << 20,
                           {"mesh", "crossed", "-o", folder.file("a.obj"), "--divisions", "2000", "2000"}),
          4, "out of memory");
    CHECK(folder.files() == 0);
}
#endif

#ifdef DRAPE_WITH_RENDER

TEST_CASE("ffmpeg dying ends a run with exit 3 and its words, and leaves no video", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop("2")), video = folder.file("a.mp4");
    const std::string ffmpeg =
        folder.file("ffmpeg", "#!/bin/sh\nhead -c 100000 > /dev/null\necho 'had enough' >&2\nexit 1\n");
    std::filesystem::permissions(ffmpeg, std::filesystem::perms::owner_all);
    const Environment path("PATH", folder.path() + ":/usr/bin:/bin");
    fails(run_drape({"render", scene, "--out", folder.file("out"), "--quiet", "--video", video}), 3,
          "a.mp4: cannot write: ffmpeg: had enough");
    CHECK_FALSE(std::filesystem::exists(video));
    CHECK(std::filesystem::exists(folder.file("out/frame_0001.png")));
    check_nothing_half_written(folder.path());
}

TEST_CASE("without a GL context render ends with exit 3 before anything is simulated", "[app]") {
    const TemporaryFolder folder, libraries;
    const std::string scene = folder.file("drop.toml", small_drop("100"));
    libraries.file("libOSMesa.so.8", "no library");
    const Environment path("LD_LIBRARY_PATH", libraries.path());
    fails(run_drape({"render", scene, "--out", folder.file("out")}), 3, "cannot load libOSMesa.so.8");
    CHECK(folder.files() == 1);
}

#endif
