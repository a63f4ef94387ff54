// Includes point one way only, in the order the data flows: `render` knows no force, `mesh` no file format.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "support/layers.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("no file of src includes one of a later stage", "[layers]") {
    const std::filesystem::path source = DRAPE_SOURCE_DIR "/src";
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp") continue;
        ++files;
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        for (const std::string& wrong :
             upward_includes(std::filesystem::relative(entry.path(), source).generic_string(), text.str()))
            FAIL_CHECK("src/" << wrong);
    }
    CHECK(files > 50);
}

TEST_CASE("the table of layers is complete and has no circle", "[layers]") {
    const std::filesystem::path source = DRAPE_SOURCE_DIR "/src";
    for (const auto& entry : std::filesystem::directory_iterator(source)) {
        if (!entry.is_directory()) continue;
        const std::string folder = entry.path().filename().string();
        CAPTURE(folder);
        // a folder without a row may not even include base
        CHECK(upward_includes(folder + "/x.cpp", "#include \"base/error.h\"\n").empty());
    }
    for (const Layer& one : layers()) {
        for (const Layer& other : layers()) {
            if (one.folder == other.folder) continue;
            const bool down =
                upward_includes(cat(one.folder, "/x.h"), cat("#include \"", other.folder, "/y.h\"")).empty();
            const bool up =
                upward_includes(cat(other.folder, "/x.h"), cat("#include \"", one.folder, "/y.h\"")).empty();
            CAPTURE(one.folder, other.folder);
            CHECK_FALSE((down && up));
        }
    }
}

TEST_CASE("an upward include is found with its file and line", "[layers]") {
    using Found = std::vector<std::string>;
    CHECK(upward_includes("mesh/mesh.h", "#pragma once\n\n#include \"io/png.h\"\n") ==
          Found{"mesh/mesh.h:3: mesh may not include io/png.h"});
    CHECK(upward_includes("render/a.cpp", "#include <map>\n  #  include \"force/wind.h\"  // why not\n") ==
          Found{"render/a.cpp:2: render may not include force/wind.h"});
    CHECK(upward_includes("render/a.cpp", "#include \"../scene/reader.h\"\n") ==
          Found{"render/a.cpp:1: render may not include ../scene/reader.h"});
    CHECK(upward_includes("new_stage/a.cpp", "#include \"base/error.h\"\n") ==
          Found{"new_stage/a.cpp:1: new_stage may not include base/error.h"});
    CHECK(upward_includes("io/png.cpp",
                          "#include \"io/png.h\"\n#include \"mesh/mesh.h\"\n#include \"shaders.h\"\n")
              .empty());
    CHECK(upward_includes("app/main.cpp", "#include \"render/renderer.h\"\n").empty());
}
