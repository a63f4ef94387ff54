#include "gallery/catalogue.h"

#include <algorithm>
#include <filesystem>

#include "io/read_file.h"
#include "toml/keys.h"

namespace drape {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_bytes = 1 << 20;  // of the file
constexpr int most_pixels = 16384, most_columns = 100, most_frames = 1 << 30;

std::vector<std::string> texts_of(const Value& value, std::string_view name) {
    std::vector<std::string> texts;
    for (const Value& item : as_array(value, name)) texts.push_back(as_text(item, name));
    return texts;
}

Pane pane_of(const Value& value, const std::vector<std::string>& common) {
    const Keys keys(value, "pane", {"label", "set"});
    Pane pane{.label = "", .set = common};
    keys.read("label", pane.label);
    if (const Value* set = keys.find("set"))
        for (const std::string& text : texts_of(*set, "set")) pane.set.push_back(text);
    return pane;
}

void demand_plain(const Place& place, const std::string& name) {
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    };
    if (name.empty() || !std::all_of(name.begin(), name.end(), plain))
        fail(place, "name: ", quoted(name), " names files (letters, digits, - and _)");
}

// A word without an ending is a demo scene; a file stands beside the catalogue.
std::string scene_of(const std::string& text, const fs::path& folder) {
    return fs::path(text).has_extension() ? fs::absolute(folder / text).lexically_normal().string() : text;
}

Piece piece_of(const Value& value, const fs::path& folder) {
    const Keys keys(value, "piece",
                    {"name", "title", "says", "scene", "size", "poster", "columns", "set", "pane"});
    Piece piece;
    piece.place = keys.place();
    const std::string& scene = as_text(keys.need("scene"), "scene");
    piece.scene = scene_of(scene, folder);
    piece.name = fs::path(scene).stem().string();
    keys.read("name", piece.name);
    demand_plain(keys.place(), piece.name);
    keys.read("title", piece.title);
    keys.read("says", piece.says);
    keys.read("columns", piece.columns, 1, most_columns);
    if (const Value* poster = keys.find("poster"))
        piece.poster = as_integer(*poster, "poster", 1, most_frames);
    if (const Value* size = keys.find("size")) {
        const std::vector<Value>& two = as_array(*size, "size", 2);
        for (const size_t i : {0U, 1U}) piece.size[i] = as_integer(two[i], "size", 16, most_pixels);
    }
    const Value* set = keys.find("set");
    const std::vector<std::string> common = set ? texts_of(*set, "set") : std::vector<std::string>{};
    if (const Value* panes = keys.find("pane"))
        for (const Value& pane : as_array(*panes, "pane")) piece.panes.push_back(pane_of(pane, common));
    else
        piece.panes.push_back({"", common});
    if (piece.panes.empty()) fail(keys.place(), "pane: a piece has at least one");
    return piece;
}

}  // namespace

Catalogue read_catalogue(const std::string& path) {
    const Value root = parse_toml(read_file(path, most_bytes), path);
    const Keys keys(root, "gallery", {"schema", "title", "piece"});
    as_integer(keys.need("schema"), "schema", 1, 1);
    Catalogue catalogue{.title = "drape gallery", .pieces = {}};
    keys.read("title", catalogue.title);
    for (const Value& value : as_array(keys.need("piece"), "piece")) {
        Piece piece = piece_of(value, fs::path(path).parent_path());
        for (const Piece& other : catalogue.pieces)
            if (other.name == piece.name)
                fail(piece.place, "name: ", quoted(piece.name), " is the name of another piece too");
        catalogue.pieces.push_back(std::move(piece));
    }
    if (catalogue.pieces.empty()) fail(keys.place(), "piece: a gallery shows at least one");
    return catalogue;
}

}  // namespace drape
