// Whole runs of the program: what they leave behind, and that it is the same every time.
#include <catch2/catch.hpp>

#include "app/small_drop.h"
#include "io/cache_reader.h"
#include "io/png.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;

namespace {

// Starts a run, and interrupts it soon after `sign` is there.
void interrupt(const char* verb, const std::string& scene, const std::string& out, const std::string& sign) {
    REQUIRE(interrupted_drape({verb, scene, "--out", out, "--quiet"},
                              [&] { return std::filesystem::exists(sign); }) == 130);
    REQUIRE(std::filesystem::exists(out + "/checkpoint"));
}

}  // namespace

TEST_CASE("simulate leaves a report with every key of the contract, and no picture", "[app]") {
    const TemporaryFolder folder;
    const Ran ran =
        run_drape({"simulate", folder.file("drop.toml", small_drop()), "--out", folder.file("out")});
    CAPTURE(ran.err);
    REQUIRE(ran.exit_code == 0);
    CHECK_THAT(ran.out, Catch::Contains("4 frames"));
    const Json report = report_of(folder.file("out"));
    for (const char* key : {"scene", "version", "machine", "method", "error", "time", "memory_peak_mb",
                            "energy", "contact", "plan", "frames"})
        CHECK(report.contains(key));
    CHECK(report["error"]["estimated_rms_m"].get<double>() > 0);
    CHECK(report["error"]["passes"].size() == 2);
    CHECK(report["machine"]["renderer"].is_null());  // no GL context was made
    CHECK(report["contact"]["deepest_penetration_m"] == 0);
    REQUIRE(report["frames"].size() == 4);
    CHECK(report["frames"][3]["time_s"] == Approx(0.4));
    CHECK(report["energy"]["drift_j"].get<double>() == Approx(0).margin(5e-3));  // measured: 4.1e-3 of 0.66 J
    bool told = false;
    for (const Json& stage : report["plan"]["left_out"]) told |= stage["stage"] == "pictures";
    CHECK(told);
    CHECK_FALSE(std::filesystem::exists(folder.file("out/frame_0001.png")));
    CHECK_FALSE(std::filesystem::exists(folder.file("out/checkpoint")));
}

TEST_CASE("a tolerance is met frame by frame; one below what can be predicted is told, and strictly refused",
          "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("swatch.toml",
                                          "schema = 1\n[scene]\nduration = 0.4\nframe_rate = 10\n[[cloth]]\n"
                                          "pattern = { name = \"alternating\", divisions = [8, 8] }\n"
                                          "fabric = { density = 0.2, stretch = { model = "
                                          "\"spring_constant\", value = 200 } }\n"
                                          "pins = [{ near = [-0.5, 0, -0.5] }]\n");
    const auto run = [&](const std::string& tolerance) {
        return run_drape({"simulate", scene, "--out", folder.file("out"), "--quiet", "--strict",
                          "--tolerance", tolerance, "--cache", folder.file("swatch.pc2")});
    };
    const Ran met = run("1e-4");
    CAPTURE(met.err);
    CHECK(met.exit_code == 0);
    // 32 bytes of header, the start and four frames
    CHECK(std::filesystem::file_size(folder.file("swatch.pc2")) == 32 + 5 * 81 * 3 * sizeof(float));
    Json error = report_of(folder.file("out"))["error"];
    CHECK(error["asked_m"] == 1e-4);
    CHECK(error["reached"] == true);
    CHECK(error["estimated_rms_m"].get<double>() <= 1e-4);
    CHECK(error["predictability_floor_m"].get<double>() < 1e-4);
    CHECK(error["below_floor_from_s"].is_null());

    const Ran refused = run("1e-13");  // nearer than the twin starts
    CHECK(refused.exit_code == 4);
    CHECK(refused.error_lines() == 1);
    CHECK_THAT(refused.err, Catch::Contains("(--strict)"));
    error = report_of(folder.file("out"))["error"];
    CHECK(error["below_floor_from_s"] == Approx(0.1));
}

TEST_CASE("a run within a budget tells how it was stepped, and its report replays to the same bits",
          "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop());
    const Ran ran =
        run_drape({"simulate", scene, "--out", folder.file("first"), "--budget", "2", "--strict"});
    CAPTURE(ran.err);
    REQUIRE(ran.exit_code == 0);
    const Json first = report_of(folder.file("first"));
    CHECK(first["budget"]["asked_s"] == 2.0);
    CHECK(first["budget"]["kept"] == true);
    CHECK(first["budget"]["spent_s"] > 1);
    CHECK(first["error"]["estimated_rms_m"].get<double>() > 0);
    REQUIRE(run_drape({"simulate", scene, "--out", folder.file("second"), "--replay",
                       folder.file("first/report.json")})
                .exit_code == 0);
    const Json second = report_of(folder.file("second"));
    CHECK(second["budget"].is_null());
    REQUIRE(second["frames"].size() == first["frames"].size());
    for (size_t k = 0; k < first["frames"].size(); ++k)
        CHECK(second["frames"][k]["hash"] == first["frames"][k]["hash"]);
    CHECK(second["error"]["estimated_rms_m"] == first["error"]["estimated_rms_m"]);
}

TEST_CASE("flags of accuracy that contradict each other are refused", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop());
    using Flags = std::vector<std::string>;
    for (const Flags& flags :
         {Flags{"--strict"}, Flags{"--tolerance", "1e-3", "--step", "1e-4"},
          Flags{"--tolerance", "1e-3", "--no-estimate"}, Flags{"--tolerance", "0"},
          Flags{"--budget", "9", "--step", "1e-4"}, Flags{"--budget", "9", "--tolerance", "1e-3"},
          Flags{"--budget", "-1"}, Flags{"--replay", "none.json"}, Flags{"--replay", scene, "--step", "1e-4"},
          Flags{"--replay", scene}}) {
        Flags words{"simulate", scene, "--out", folder.file("out")};
        words.insert(words.end(), flags.begin(), flags.end());
        const Ran ran = run_drape(words);
        CAPTURE(flags.front(), ran.err);
        CHECK(ran.exit_code == 2);
        CHECK(ran.error_lines() == 1);
    }
}

TEST_CASE("a start that crosses itself runs once it is asked to be untangled", "[app]") {
    const TemporaryFolder folder;
    // a corner of the upper sheet starts through the lower one
    const std::string sheet = "fabric = \"cotton\"\nself_contact = true\n";
    const std::string scene = folder.file(
        "tangled.toml",
        "schema = 1\n[scene]\nduration = 0.1\n[[cloth]]\n" + sheet +
            "pattern = { name = \"alternating\", size = [0.5, 0.5], divisions = [16, 16] }\n[[cloth]]\n" +
            sheet +
            "pattern = { name = \"alternating\", size = [0.4, 0.4], divisions = [12, 12] }\n"
            "place = { translate = [0, 0.1, 0], rotate_deg = [0, 45, 30] }\n");
    const std::string out = folder.file("out");
    CHECK_THAT(run_drape({"simulate", scene, "--out", out}).err, Catch::Contains("starts crossing"));
    const Ran ran = run_drape({"simulate", scene, "--out", out, "--no-estimate", "--untangle"});
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 0);
    CHECK_THAT(ran.err, Catch::Contains("untangled the start: "));
    CHECK(report_of(out)["contact"]["crossings"] == 0);
    const Ran idle = run_drape(
        {"simulate", folder.file("drop.toml", small_drop()), "--out", out, "--no-estimate", "--untangle"});
    CHECK(idle.exit_code == 0);
    CHECK_THAT(idle.err, Catch::Contains("nothing to untangle"));
}

TEST_CASE("a cache holds the start and every frame", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop());
    for (const std::string ending : {"pc2", "mdd"}) {
        REQUIRE(
            run_drape({"simulate", scene, "--out", folder.file("out"), "--cache", folder.file("c." + ending)})
                .exit_code == 0);
        const Cache cache = read_cache(folder.file("c." + ending));
        REQUIRE(cache.samples.size() == 5);
        CHECK(cache.samples[0].cols() == 13 * 13);
        CHECK(cache.samples[0].row(1).maxCoeff() == Approx(0.45));
        CHECK(cache.samples[4].row(1).minCoeff() < 0.3);
    }
    REQUIRE(run_drape({"simulate", scene, "--out", folder.file("out"), "--cache", folder.file("c.obj")})
                .exit_code == 0);
    CHECK(std::filesystem::exists(folder.file("c_0004.obj")));
}

TEST_CASE("the same scene gives the same frames, whatever else is asked", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop());
    const auto hashes = [&](const std::string& out, std::vector<std::string> more) {
        more.insert(more.begin(), {"simulate", scene, "--out", folder.file(out)});
        REQUIRE(run_drape(more).exit_code == 0);
        std::vector<std::string> all;
        const Json report = report_of(folder.file(out));
        for (const Json& frame : report["frames"]) all.push_back(frame["hash"]);
        return all;
    };
    const auto plain = hashes("a", {});
    CHECK(plain.size() == 4);
    CHECK(plain[0] != plain[3]);
    CHECK(hashes("b", {"--threads", "1", "--cache", folder.file("c.pc2")}) == plain);
    CHECK(hashes("c", {"--set", "render.ground=false"}) == plain);
    CHECK(hashes("d", {"--set", "scene.gravity=[0, -9.8, 0]"}) != plain);
    CHECK(hashes("e", {"--set", "expect={ outcome = \"stops\" }"}) == plain);
}

TEST_CASE("an interrupted run resumes to the same bits", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop("3"));
    REQUIRE(run_drape({"simulate", scene, "--out", folder.file("whole")}).exit_code == 0);

    const std::string out = folder.file("cut");
    interrupt("simulate", scene, out, out);
    const auto done = report_of(out)["frames"].size();
    CHECK(done < 30);

    const Ran resumed = run_drape({"simulate", scene, "--out", out, "--resume"});
    CAPTURE(resumed.err);
    REQUIRE(resumed.exit_code == 0);
    CHECK(report_of(out)["frames"].back()["hash"] ==
          report_of(folder.file("whole"))["frames"].back()["hash"]);
    CHECK_FALSE(std::filesystem::exists(out + "/checkpoint"));
    // nothing to resume: a fresh run
    CHECK(run_drape({"simulate", scene, "--out", folder.file("whole"), "--resume"}).exit_code == 0);
}

TEST_CASE("a step that no halving saves stops with exit 4 and the last good state; auto takes another method",
          "[app]") {
    const TemporaryFolder folder;
    const auto scene = [&](const std::string& times) {
        return folder.file(
            "s.toml",
            "schema = 1\n[scene]\n" + times +
                "[[cloth]]\npattern = { name = \"alternating\", size = [1, 1], divisions = [8, 8] }\n"
                "fabric = \"cotton\"\npins = [{ near = [-0.5, 0, -0.5] }]\n");
    };
    const Ran ran = run_drape({"simulate", scene("duration = 200\nframe_rate = 0.005\n"), "--out",
                               folder.file("out"), "--step", "200", "--quiet", "--method", "verlet"});
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 4);
    CHECK(ran.error_lines() == 1);
    CHECK_THAT(ran.err, Catch::Contains("longest stable") && Catch::Contains("at vertex"));
    CHECK(std::filesystem::exists(folder.file("out/checkpoint")));

    const std::string short_one = scene("duration = 1\n");
    CHECK(run_drape({"simulate", short_one, "--out", folder.file("other"), "--step", "0.02"}).exit_code == 0);
    CHECK(report_of(folder.file("other"))["method"]["name"] == "tr_bdf2");
    const Ran halved = run_drape(
        {"simulate", short_one, "--out", folder.file("halved"), "--step", "0.005", "--method", "verlet"});
    CHECK(halved.exit_code == 0);
    CHECK_THAT(halved.out, Catch::Contains("shorter steps"));
}

TEST_CASE("inspect prints plan, mesh, step and a scene that reads back as itself", "[app]") {
    const TemporaryFolder folder;
    const Ran ran = run_drape({"inspect", folder.file("drop.toml", small_drop())});
    REQUIRE(ran.exit_code == 0);
    for (const char* part :
         {"vertices            169", "plan", "left out wind", "guaranteed stable", "predicted cost"})
        CHECK_THAT(ran.out, Catch::Contains(part));
    const std::string scene = ran.out.substr(ran.out.find("schema = 1"));
    const Ran again = run_drape({"inspect", folder.file("again.toml", scene)});
    REQUIRE(again.exit_code == 0);
    CHECK(again.out.substr(again.out.find("schema = 1")) == scene);
}

TEST_CASE("a name with line breaks and colours in it stays one line without any", "[app]") {
    const TemporaryFolder folder;
    const Ran ran = run_drape(
        {"inspect", folder.file("drop.toml", small_drop()), "--set", "scene.name=\"a\\nb\\u001b[31m\""});
    CAPTURE(ran.out, ran.err);
    CHECK(ran.exit_code == 0);
    CHECK_THAT(ran.out, Catch::Contains("drop.toml: a?b?[31m, "));
    CHECK(ran.out.find('\x1b') == std::string::npos);
}

TEST_CASE("inspect says any step where nothing binds one", "[app]") {
    const TemporaryFolder folder;
    const Ran ran = run_drape(
        {"inspect", folder.file("drop.toml", small_drop()), "--set", "accuracy.method=backward_euler"});
    CHECK(ran.exit_code == 0);
    CHECK_THAT(ran.out, Catch::Contains("longest stable      any step (") && !Catch::Contains("inf s"));
}

TEST_CASE("mesh writes what inspect reads", "[app]") {
    const TemporaryFolder folder;
    for (const std::string ending : {"obj", "ply"}) {
        const std::string file = folder.file("sheet." + ending);
        REQUIRE(run_drape({"mesh", "alternating", "-o", file, "--size", "2", "1", "--divisions", "8", "4"})
                    .exit_code == 0);
        const Ran ran = run_drape({"inspect", file});
        CHECK(ran.exit_code == 0);
        CHECK_THAT(ran.out, Catch::Contains("vertices            45 (45 in the file)") &&
                                Catch::Contains("size                2 x 0 x 1 m, area 2 m^2"));
    }
}

#ifdef DRAPE_WITH_RENDER

TEST_CASE("pictures of a resumed run are those of one that was never interrupted", "[app]") {
    const TemporaryFolder folder;
    std::string text = small_drop("3");
    // framed by what the cloth will take up, seen from its start
    const size_t camera = text.find("camera = ");
    text.erase(camera, text.find('\n', camera) - camera);
    const std::string scene = folder.file("drop.toml", text);
    REQUIRE(run_drape({"render", scene, "--out", folder.file("whole")}).exit_code == 0);
    const std::string out = folder.file("cut");
    interrupt("render", scene, out, out + "/frame_0004.png");
    REQUIRE_FALSE(std::filesystem::exists(out + "/frame_0030.png"));
    REQUIRE(run_drape({"render", scene, "--out", out, "--resume"}).exit_code == 0);
    for (const char* frame : {"/frame_0001.png", "/frame_0020.png", "/frame_0030.png"})
        CHECK(bytes_of(out + frame) == bytes_of(folder.file("whole") + frame));
}

TEST_CASE("pictures are the same whether the passes run by turns or side by side", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop());
    for (const char* threads : {"1", "3"})
        REQUIRE(run_drape({"render", scene, "--threads", threads, "--quiet", "--out", folder.file(threads)})
                    .exit_code == 0);
    for (const char* frame : {"/frame_0001.png", "/frame_0002.png", "/frame_0003.png", "/frame_0004.png"})
        CHECK(bytes_of(folder.file("1") + frame) == bytes_of(folder.file("3") + frame));
    const Json time = report_of(folder.file("3"))["time"];
    CHECK(time["render_s"].get<double>() > 0);
    CHECK(time["encode_s"].get<double>() > 0);
}

TEST_CASE("a picture that cannot be written ends the run with exit 3", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop());
    // in the way, though no frame of an earlier run: a folder that is not empty
    std::filesystem::create_directories(folder.file("out") + "/frame_0002.png/kept");
    // one thread draws: of several, another may have the picture after in hand
    const Ran ran = run_drape(
        {"render", scene, "--frames", "1:4", "--threads", "1", "--quiet", "--out", folder.file("out")});
    CHECK(ran.exit_code == 3);
    CHECK(ran.error_lines() == 1);
    CHECK(std::filesystem::exists(folder.file("out") + "/frame_0001.png"));
    CHECK_FALSE(std::filesystem::exists(folder.file("out") + "/frame_0003.png"));
}

TEST_CASE("render leaves a picture per frame, the cloth where the camera sees it", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("drop.toml", small_drop());
    const Ran ran = run_drape({"render", scene, "--out", folder.file("out"), "--set",
                               "cloth.0.colour.front=\"#20a030\"", "--frames", "3:4"});
    CAPTURE(ran.err);
    REQUIRE(ran.exit_code == 0);
    CHECK_FALSE(std::filesystem::exists(folder.file("out/frame_0002.png")));
    const Image picture = read_png(folder.file("out/frame_0004.png"));
    REQUIRE(picture.width == 160);
    REQUIRE(picture.height == 90);
    int green = 0;
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 160; ++x) {
            const std::uint8_t* p = picture.pixel(x, y);
            green += p[1] > 1.3 * p[0] && p[1] > 1.3 * p[2];
        }
    CHECK(green > 1000);
    CHECK_FALSE(report_of(folder.file("out"))["machine"]["renderer"].is_null());
    const std::uint8_t* middle = picture.pixel(80, 40);
    CHECK((middle[1] > middle[0] && middle[1] > middle[2]));

    REQUIRE(run_drape({"render", scene, "--out", folder.file("again"), "--set",
                       "cloth.0.colour.front=\"#20a030\"", "--threads", "1"})
                .exit_code == 0);
    CHECK(bytes_of(folder.file("again/frame_0004.png")) == bytes_of(folder.file("out/frame_0004.png")));
}

#else

TEST_CASE("a program without the renderer says so, and still simulates", "[app]") {
    const TemporaryFolder folder;
    const Ran ran = run_drape({"render", folder.file("drop.toml", small_drop())}, folder.path());
    CHECK(ran.exit_code == 2);
    CHECK_THAT(ran.err, Catch::Contains("built without a renderer"));
}

#endif

TEST_CASE("a run that is interrupted ends within a frame that takes long", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("storm.toml", small_drop("0.4", "[air]\nwind = [1e9, 0, 0]\n")),
                      out = folder.file("out");
    CHECK(interrupted_drape({"simulate", scene, "--out", out, "--method", "backward_euler", "--quiet"},
                            [&] { return std::filesystem::exists(out); }) == 130);
    CHECK_FALSE(std::filesystem::exists(out + "/report.json"));
}
