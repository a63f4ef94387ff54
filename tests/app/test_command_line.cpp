// Usage and bad input: one line, the right exit code, nothing left behind.
#include <array>
#include <cstdio>
#include <memory>

#include <catch2/catch.hpp>

#include "support/run_program.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;

namespace {

// A scene of a few triangles and one frame, with `more` at its end.
std::string tiny_scene(const std::string& more = "") {
    return "schema = 1\n[scene]\nduration = 0.1\nframe_rate = 10\n"
           "[[cloth]]\npattern = { name = \"alternating\", size = [1, 1], divisions = [4, 4] }\n"
           "fabric = \"cotton\"\n" +
           more;
}

// Runs `verb` on a scene written to a fresh folder and expects exit 2 with one line that contains `says`.
void refused(const std::string& verb, const std::string& scene, const std::string& says) {
    const TemporaryFolder folder;
    const Ran ran = run_drape({verb, folder.file("bad.toml", scene), "--out", folder.file("out")});
    CAPTURE(scene, ran.err);
    CHECK(ran.exit_code == 2);
    CHECK(ran.error_lines() == 1);
    CHECK_THAT(ran.err, Catch::StartsWith("drape: ") && Catch::Contains(says));
    CHECK(folder.files() == 1);  // the scene alone: nothing half-written
}

}  // namespace

TEST_CASE("wrong usage is one line and exit 2", "[app]") {
    const struct {
        std::vector<std::string> arguments;
        std::string says;
    } cases[] = {
        {{}, "render, simulate, inspect, study, stability, lab, compare, video, gallery, mesh, list"},
        {{"rendr", "x.toml"}, "did you mean \"render\"?"},
        {{"simulate"}, "SCENE is required"},
        {{"simulate", "sphere_drop", "--stepp", "1"}, "did you mean \"--step\"?"},
        {{"simulate", "sphere_drop", "--step", "0"}, "--step 0: expected seconds over 0"},
        {{"simulate", "sphere_drop", "--step", "nan"}, "--step nan"},
        {{"simulate", "sphere_drop", "--method", "verlett"}, "did you mean \"verlet\"?"},
        {{"simulate", "sphere_dorp"}, "did you mean \"sphere_drop\"?"},
        {{"simulate", "nowhere/scene.toml"}, "nowhere/scene.toml: no such file"},
        {{"simulate", "sphere_drop", "more"}, "unexpected argument \"more\""},
        {{"inspect", "nothing.obj"}, "nothing.obj"},
        {{"mesh", "one_wya", "-o", "x.obj"}, "did you mean \"one_way\"?"},
        {{"mesh", "one_way", "-o", "x.stl"}, ".obj, .ply"},
        {{"mesh", "one_way", "-o", "x.obj", "--over", "disk"}, "did you mean \"disc\"?"},
        {{"mesh", "adaptive", "-o", "x.obj"}, "adaptive needs finer"},
        {{"mesh", "adaptive", "-o", "x.obj", "--finer", "{ point = 1 }"}, "did you mean \"points\"?"},
        {{"mesh", "one_way", "-o", "x.obj", "--outline", "[[0, 0], [1, 0]]"}, "at least 3 corners, got 2"},
        {{"mesh", "one_way", "-o", "x.obj", "--remesh", "y.obj"}, "y.obj: no such file"},
        {{"mesh", "one_way", "-o", "x.obj", "--remesh", "y.obj", "--over", "disc"},
         "--remesh: the mesh says"},
        {{"video", "."}, "--out is required"},
        {{"video", ".", "-o", "x.mp4"}, ".: no numbered PNG pictures"},
        {{"video", "nowhere", "-o", "x.mp4"}, "nowhere: no such folder"},
        {{"video", ".", "-o", "x.avi"}, "(known: .mp4, .webm, .webp, .gif)"},
        {{"video", ".", "-o", "x.mp4", "--speed", "0"}, "--speed 0: expected"},
        {{"video", ".", "-o", "x.mp4", "--loop", "0"}, "--loop"},
        {{"video", ".", "-o", "x.mp4", "--at-most", "0"}, "--at-most 0: expected megabytes over 0"},
        {{"gallery", "nowhere.toml"}, "nowhere.toml: no such file"},
        {{"video", ".", "-o", "x.mp4", "--difference"}, "--difference: only with --side-by-side"},
        {{"video", ".", "-o", "x.mp4", "--label", "a", "--label", "b"}, "--label: given 2 times for 1"},
        {{"compare", ".", ".", "--ignore", "1,2,3"}, "--ignore 1,2,3: expected X,Y,W,H in pixels"},
        {{"compare", ".", ".", "--limit", "flpi=1"}, "did you mean \"flip\"?"},
        {{"compare", ".", ".", "--share", "2"}, "share: expected a number from 0 to 1, found \"2\""},
        {{"compare", "nowhere", "."}, "nowhere: no such file or folder"},
        {{"list", "methds"}, "did you mean \"methods\"?"},
    };
    for (const auto& c : cases) {
        const TemporaryFolder folder;
        const Ran ran = run_drape(c.arguments, folder.path());
        CAPTURE(c.says, ran.err, ran.out);
        CHECK(ran.exit_code == 2);
        CHECK(ran.error_lines() == 1);
        CHECK_THAT(ran.err, Catch::Contains(c.says));
        CHECK(folder.files() == 0);
    }
}

TEST_CASE("a wrong scene is one line with its place, and exit 2", "[app]") {
    refused("simulate", tiny_scene("pinz = []\n"),
            "bad.toml:8:1: unknown cloth key \"pinz\"; did you mean \"pins\"?");
    refused("simulate", tiny_scene("pins = [{ near = [9, 9, 9] }]\n"), "pin matches nothing");
    refused("simulate", tiny_scene("pins = 3\n"), "bad.toml:8:8");
    refused("simulate", tiny_scene("[[obstacle]]\nshape = \"sphere\"\nradius = -1\n"), "radius");
    refused("simulate", tiny_scene("[[obstacle]]\nshape = \"spere\"\n"), "did you mean \"sphere\"?");
    refused("simulate", "schema = 1\n[scene]\nduration = 0.01\n[[cloth]]\nmesh = \"x.obj\"\n", "frames");
    refused("simulate", "schema = 1\n[[cloth]]\nmesh = \"x.obj\"\nfabric = \"cotton\"\n",
            "x.obj: no such file");
    refused("simulate", "schema = 1\n[[cloth]]\nmesh = \"x\\ny\\u001b[2J.obj\"\nfabric = \"cotton\"\n",
            "x?y?[2J.obj: no such file");
    refused("simulate", "schema = 1\n[[cloth]]\nmesh = \"x.obj\"\nfabric = { density = -1 }\n", "density");
}

TEST_CASE("a broken mesh is one line and exit 2", "[app]") {
    const struct {
        std::string name, bytes, says;
    } cases[] = {
        {"empty.obj", "", "empty"},
        {"nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "nan.obj:1"},
        {"range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "range.obj:4"},
        {"cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", "cut.ply"},
        {"huge.ply",
         "ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\nproperty float x\nproperty float "
         "y\n"
         "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n",
         "huge.ply"},
    };
    for (const auto& c : cases) {
        const TemporaryFolder folder;
        const std::string path = folder.file(c.name, c.bytes);
        const Ran ran = run_drape({"inspect", path});
        CAPTURE(c.name, ran.err);
        CHECK(ran.exit_code == 2);
        CHECK(ran.error_lines() == 1);
        CHECK_THAT(ran.err, Catch::Contains(c.says));
    }
}

TEST_CASE("help and version are answered, exit 0", "[app]") {
    const Ran help = run_drape({"--help"});
    CHECK(help.exit_code == 0);
    for (const std::string verb :
         {"render", "simulate", "inspect", "study", "stability", "lab", "video", "gallery", "mesh", "list"})
        CHECK_THAT(help.out, Catch::Contains(verb));
    CHECK(run_drape({"render", "--help"}).exit_code == 0);
    CHECK_THAT(run_drape({"--version"}).out, Catch::StartsWith("drape "));
}

TEST_CASE("the program starts without loading OpenGL", "[app]") {
    // the dynamic loader lists what it loads at start-up instead of running the program
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(
        popen("LD_TRACE_LOADED_OBJECTS=1 '" DRAPE_PROGRAM "'", "r"), pclose);
    REQUIRE(pipe);
    std::string loaded;
    std::array<char, 512> line{};
    while (std::fgets(line.data(), static_cast<int>(line.size()), pipe.get())) loaded += line.data();
    CHECK_THAT(loaded, Catch::Contains("libc.so"));
    for (const char* library : {"OSMesa", "libEGL", "libGL", "LLVM"})
        CHECK_THAT(loaded, !Catch::Contains(library));
}

TEST_CASE("output that cannot be written is exit 3", "[app]") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("tiny.toml", tiny_scene());
    const std::string file = folder.file("a_file", "");
    const Ran ran = run_drape({"simulate", scene, "--out", file + "/below"});
    CHECK(ran.exit_code == 3);
    CHECK(ran.error_lines() == 1);
    CHECK(run_drape({"mesh", "one_way", "-o", file + "/x.obj"}).exit_code == 3);
}

TEST_CASE("list names what scenes may use", "[app]") {
    const Ran ran = run_drape({"list"});
    CHECK(ran.exit_code == 0);
    for (const std::string name :
         {"sphere_drop", "cotton", "takahashi_imada", "torus", "one_way", "neo_hookean"})
        CHECK_THAT(ran.out, Catch::Contains(name));
}
