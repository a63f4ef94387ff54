#include "scene/reader.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "scene/overrides.h"
#include "scene/read_parts.h"
#include "toml/keys.h"

namespace drape {

namespace {

constexpr std::uintmax_t most_bytes = 1 << 20;  // of a scene file
constexpr double most_frames = 1e6;

std::string file_text(const std::string& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) throw Error(path + ": no such file");
    if (std::filesystem::is_directory(status)) throw Error(path + ": is a folder, not a scene file");
    std::ifstream file(path, std::ios::binary);
    // a pipe or device has no size to ask for: read up to the limit and one more
    std::string text(most_bytes + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad() || !(file || file.eof())) throw Error(path + ": cannot be read");
    text.resize(static_cast<size_t>(file.gcount()));
    if (text.size() > most_bytes) throw Error(path + ": too large for a scene file (at most 1 MiB)");
    return text;
}

void check_schema(const Value& root, const std::string& path) {
    const Value* schema = root.find("schema");
    if (!schema) throw Error(path + ":1:1: schema is missing (schema = 1)");
    if (schema->kind != Value::Kind::integer || schema->integer != 1)
        fail(schema->place, "schema must be 1, found ", description_of(*schema));
}

// name, duration, frame rate, gravity, seed
void read_scene_table(const Value& value, SceneDescription& scene) {
    const Keys keys(value, "scene", {"name", "duration", "frame_rate", "gravity", "seed"});
    keys.read("name", scene.name);
    keys.read("duration", scene.duration, positive("s"));
    keys.read("frame_rate", scene.frame_rate, positive("frames/s"));
    keys.read("gravity", scene.gravity, any("m/s^2"));
    int seed = 1;
    keys.read("seed", seed, 0, std::numeric_limits<int>::max());
    scene.seed = static_cast<std::uint64_t>(seed);

    const double frames = scene.duration * scene.frame_rate;
    if (std::round(frames) < 1)
        fail(keys.place(), "duration times frame_rate is ", frames, " frames (at least 1)");
    if (frames > most_frames)
        fail(keys.place(), "duration times frame_rate is ", frames, " frames (at most ", most_frames, ")");
}

// the tables of [[cloth]] or [[obstacle]]
const std::vector<Value>& tables_of(const Value& value, const std::string& name) {
    if (value.kind == Value::Kind::table)
        fail(value.place, name, ": expected an array of tables, found one (write [[", name, "]])");
    return as_array(value, name);
}

}  // namespace

SceneDescription read_scene(const std::string& path, const std::vector<std::string>& overrides) {
    return read_scene_text(file_text(path), path, overrides);
}

SceneDescription read_scene_text(std::string_view text, const std::string& path,
                                 const std::vector<std::string>& overrides) {
    Value root = parse_toml(text, path);
    for (const std::string& assignment : overrides) apply_override(root, assignment);
    check_schema(root, path);
    const Keys keys(root, "scene file",
                    {"schema", "scene", "accuracy", "cloth", "obstacle", "air", "render", "expect"});

    SceneDescription scene;
    scene.file = path;
    scene.folder = std::filesystem::path(path).parent_path().string();
    scene.name = std::filesystem::path(path).stem().string();
    if (const Value* table = keys.find("scene")) read_scene_table(*table, scene);
    if (const Value* accuracy = keys.find("accuracy")) scene.accuracy = read_accuracy(*accuracy);
    if (const Value* cloths = keys.find("cloth"))
        for (const Value& cloth : tables_of(*cloths, "cloth")) scene.cloths.push_back(read_cloth(cloth));
    if (scene.cloths.empty()) throw Error(path + ":1:1: no cloth (at least one [[cloth]])");
    if (const Value* obstacles = keys.find("obstacle"))
        for (const Value& obstacle : tables_of(*obstacles, "obstacle"))
            scene.obstacles.push_back(read_obstacle(obstacle));
    if (const Value* air = keys.find("air")) scene.air = read_air(*air);
    scene.air.seed = scene.seed;
    if (const Value* look = keys.find("render")) scene.look = read_look(*look);
    if (const Value* expect = keys.find("expect")) scene.expected = read_expect(*expect);
    return scene;
}

}  // namespace drape
