#include "support/layers.h"

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>

#include "base/error.h"

namespace drape::test {

namespace {

// a file generated at build (shaders, version) is included by its bare name and belongs to the folder using
// it
constexpr std::array table{
    Layer{"base", ""},
    Layer{"mesh", "base"},
    Layer{"cloth", "mesh base"},
    Layer{"force", "cloth mesh base"},
    Layer{"obstacle", "mesh base"},
    Layer{"contact", "obstacle cloth mesh base"},
    Layer{"integrate", "force contact cloth mesh base"},
    Layer{"simulate", "integrate contact force obstacle cloth mesh base"},
    Layer{"io", "mesh base"},
    Layer{"toml", "base"},
    Layer{"scene", "toml io simulate integrate contact force obstacle cloth mesh base"},
    Layer{"picture", "base"},
    Layer{"render", "picture mesh base"},
    Layer{"report", "simulate base"},
    Layer{"compare", "toml picture io base"},
    Layer{"video", "picture io base"},
    Layer{"gallery", "toml io base"},
    Layer{"study",
          "compare report render scene toml io simulate integrate contact force obstacle cloth mesh base"},
    Layer{"lab", "study scene io simulate integrate contact force obstacle cloth mesh base"},
    Layer{"app", "*"},
};

std::string_view folder_of(std::string_view path) {
    return path.substr(0, path.find('/'));
}

bool allowed(std::string_view from, std::string_view to) {
    if (from == to) return true;
    const auto layer =
        std::find_if(table.begin(), table.end(), [&](const Layer& row) { return row.folder == from; });
    if (layer == table.end()) return false;
    if (layer->may_include == "*") return true;
    std::istringstream words{std::string(layer->may_include)};
    for (std::string word; words >> word;)
        if (word == to) return true;
    return false;
}

}  // namespace

std::span<const Layer> layers() {
    return table;
}

std::vector<std::string> upward_includes(std::string_view file, std::string_view text) {
    static const std::regex include("^\\s*#\\s*include\\s*\"([^\"]+)\"");
    std::vector<std::string> wrong;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::smatch match;
        if (!std::regex_search(line, match, include)) continue;
        const std::string path = match[1];
        const bool generated = path.find('/') == std::string::npos;
        if (!generated && !allowed(folder_of(file), folder_of(path)))
            wrong.push_back(cat(file, ":", number, ": ", folder_of(file), " may not include ", path));
    }
    return wrong;
}

}  // namespace drape::test
