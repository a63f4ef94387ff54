#include "render/shader.h"

#include <catch2/catch.hpp>

#include <fstream>

#include "base/error.h"
#include "render/shader_table.h"

using namespace drape;

namespace {

struct Setting {
    std::unique_ptr<Context> context = make_context(Backend::osmesa);
    Gl gl = (context->make_current(), Gl(*context));
};

}  // namespace

TEST_CASE("a shader that does not compile is an error naming its file and line", "[render]") {
    Setting setting;
    const ShaderFile common{"common.glsl", "const float one = 1.0;\n"};
    const ShaderFile wrong{"wrong.frag", "out vec4 colour;\nvoid main() {\n    colour = vec4(on);\n}\n"};
    try {
        Program(setting.gl, {shader_file("screen.vert")}, {common, wrong});
        FAIL("compiled");
    } catch (const Error& error) {
        CHECK_THAT(error.what(), Catch::StartsWith("shaders/wrong.frag:3:"));
        CHECK_THAT(error.what(), Catch::Contains("on"));
        CHECK(error.code() == Exit::cannot_write);
    }
}

TEST_CASE("stages that do not fit together are an error naming both", "[render]") {
    Setting setting;
    const ShaderFile lonely{"lonely.frag",
                            "in vec3 never_written;\nout vec4 c;\nvoid main() { c = never_written.xyzz; }\n"};
    CHECK_THROWS_WITH(Program(setting.gl, {shader_file("screen.vert")}, {lonely}),
                      Catch::Contains("lonely.frag"));
}

TEST_CASE("shaders are embedded byte for byte, quotes and semicolons included", "[render]") {
    REQUIRE(shader_table().size() > 10);
    for (const ShaderFile& file : shader_table()) {
        CAPTURE(file.name);
        std::ifstream stream(std::string(DRAPE_SOURCE_DIR "/shaders/") + std::string(file.name));
        REQUIRE(stream);
        CHECK(file.text == std::string(std::istreambuf_iterator<char>(stream), {}));
    }
    CHECK_THROWS_AS(shader_file("no_such.frag"), Error);
}
