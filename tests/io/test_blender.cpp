// Caches as Blender reads them, where it is installed: a gigabyte that no build asks for.
#include <cstdlib>

#include <catch2/catch.hpp>

#include "io/cache_writer.h"
#include "mesh/pattern.h"
#include "support/ffmpeg.h"
#include "support/temporary_folder.h"

using namespace drape;

TEST_CASE("Blender moves a cloth by our caches as they have it", "[io]") {
    if (std::system("command -v blender > /dev/null 2>&1") != 0) {
        WARN("skipped: blender is not installed");
        return;
    }
    const TemporaryFolder folder;
    const Mesh mesh = make_pattern("alternating", {.width = 1, .depth = 1, .columns = 4, .rows = 3});
    for (const char* name : {"cloth.pc2", "cloth.mdd", "cloth.glb"}) {
        const auto writer = make_cache_writer(folder.file(name), mesh, 25, 3);
        for (int k = 0; k < 3; ++k) {
            Points x = mesh.rest;
            for (int v = 0; v < x.cols(); ++v) x.col(v) += k * Vec3(0.1, std::sin(v), 1.0 / 3);
            writer->add(x);
        }
        writer->finish();
    }
    const std::string said = test::output_of(
        "timeout 200 blender --background --factory-startup --python '" TEST_DATA "/read_caches.py' -- '" +
        folder.path() + "' 2>&1");
    CAPTURE(said);
    CHECK(said.find("apart pc2 0.0\n") != std::string::npos);
    CHECK(said.find("apart mdd 0.0\n") != std::string::npos);
    if (said.find("no numpy\n") != std::string::npos) {
        WARN("skipped in part: Blender's glTF importer needs python3-numpy");
        return;
    }
    const size_t at = said.find("apart glb ");
    REQUIRE(at != std::string::npos);
    CHECK(std::stod(said.substr(at + 10)) < 3e-7);  // single precision, of numbers up to 3
    CHECK(said.find("uv 1 two-sided True") != std::string::npos);
}
