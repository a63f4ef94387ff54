// [render]: the picture's size, the camera, overlays; and colours wherever they stand.

#include <algorithm>
#include <charconv>

#include "scene/read_parts.h"
#include "toml/keys.h"

namespace drape {

namespace {

CameraDescription read_camera(const Value& value) {
    const Keys keys(value, "camera", {"from", "at", "fov_deg"});
    CameraDescription camera;
    camera.from = as_vector(keys.need("from"), "from", any("m"));
    camera.at = as_vector(keys.need("at"), "at", any("m"));
    keys.read("fov_deg", camera.fov_deg, {.unit = "degrees", .least = 1, .most = 170});
    if (camera.from == camera.at) fail(keys.place(), "camera: from and at are the same point");
    return camera;
}

}  // namespace

Colour read_colour(const Value& value, std::string_view name) {
    const std::string& text = as_text(value, name);
    unsigned rgb = 0;
    const auto [end, error] =
        std::from_chars(text.data() + !text.empty(), text.data() + text.size(), rgb, 16);
    if (text.size() != 7 || text[0] != '#' || error != std::errc() || end != text.data() + text.size())
        fail(value.place, name, ": expected a colour such as \"#b82121\", found the text ", in_quotes(text));
    const auto part = [&](int shift) { return static_cast<float>(rgb >> shift & 0xff) / 255.0f; };
    return {part(16), part(8), part(0)};
}

LookDescription read_look(const Value& value) {
    const Keys keys(value, "render", {"size", "camera", "overlay", "ground"});
    LookDescription look;
    if (const Value* size = keys.find("size")) {
        const std::vector<Value>& sides = as_array(*size, "size", 2);
        look.size = {as_integer(sides[0], "size", 16, 8192), as_integer(sides[1], "size", 16, 8192)};
    }
    if (const Value* camera = keys.find("camera")) look.camera = read_camera(*camera);
    if (const Value* overlay = keys.find("overlay"))
        look.overlay =
            as_word(*overlay, "overlay", {"none", "wire", "strain", "springs", "error", "contacts"});
    keys.read("ground", look.ground);
    return look;
}

}  // namespace drape
