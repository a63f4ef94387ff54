#include <catch2/catch.hpp>

#include "support/scene_file.h"

using namespace drape;
using namespace drape::test;

namespace {

// `keys` start at line 5
std::string with_render(const std::string& keys) {
    return with_cloth("[render]\n" + keys + "\n");
}

}  // namespace

TEST_CASE("a picture is 16 to 8192 pixels wide and high", "[scene]") {
    CHECK(scene_of(with_render("size = [16, 8192]")).look.size == std::array{16, 8192});
    CHECK(error_of(with_render("size = [15, 720]")) ==
          "scene.toml:5:9: size must be from 16 to 8192, got 15");
    CHECK(error_of(with_render("size = [1280, 8193]")) ==
          "scene.toml:5:15: size must be from 16 to 8192, got 8193");
    CHECK(error_of(with_render("size = [1280.0, 720]")) ==
          "scene.toml:5:9: size: expected an integer, found the number 1280");
}

TEST_CASE("a camera stands apart from what it looks at", "[scene]") {
    const auto look = scene_of(with_render("camera = { from = [1, 2, 3], at = [0, 0, 0] }")).look;
    CHECK(look.camera->from == Vec3(1, 2, 3));
    CHECK(look.camera->fov_deg == 24);
    CHECK(error_of(with_render("camera = { from = [1, 2, 3] }")) == "scene.toml:5:10: camera: at is missing");
    CHECK(error_of(with_render("camera = { from = [1, 2, 3], at = [1, 2, 3] }")) ==
          "scene.toml:5:10: camera: from and at are the same point");
    CHECK(error_of(with_render("camera = { from = [1, 2, 3], at = [0, 0, 0], fov_deg = 180 }")) ==
          "scene.toml:5:56: fov_deg must be from 1 to 170 degrees, got 180 degrees");
}

TEST_CASE("overlays read by name", "[scene]") {
    for (const char* overlay : {"none", "wire", "strain", "springs", "error", "contacts"})
        CHECK(scene_of(with_render("overlay = \"" + std::string(overlay) + "\"")).look.overlay == overlay);
    CHECK(error_of(with_render("overlay = \"wires\"")) ==
          "scene.toml:5:11: unknown overlay \"wires\"; did you mean \"wire\"? (known: none, wire, strain, "
          "springs, error, contacts)");
}

TEST_CASE("a colour is six hexadecimal digits after #", "[scene]") {
    CHECK(error_of(with_cloth("colour = { front = \"red\" }\n")) ==
          "scene.toml:4:20: front: expected a colour such as \"#b82121\", found the text \"red\"");
    for (const char* wrong : {"", "#", "#12345", "#1234567", "#12345g", "#-12345", "#+12345", "b82121 "}) {
        CAPTURE(wrong);
        CHECK(error_of(with_cloth("colour = { front = \"" + std::string(wrong) + "\" }\n"))
                  .starts_with("scene.toml:4:20: front: expected a colour"));
    }
}
