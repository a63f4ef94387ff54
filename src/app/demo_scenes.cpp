#include "app/demo_scenes.h"

#include <algorithm>
#include <filesystem>

#include "base/names.h"

namespace drape {

namespace fs = std::filesystem;

std::vector<DemoScene> demo_scenes() {
    std::error_code none;
    const fs::path here = fs::read_symlink("/proc/self/exe", none).parent_path();
    std::vector<DemoScene> scenes;
    // build/PRESET/drape, bin/drape
    for (const fs::path& folder : {here / "../../assets/scenes", here / "../share/drape/scenes"}) {
        for (const auto& entry : fs::directory_iterator(folder, none))
            if (entry.path().extension() == ".toml")
                scenes.push_back({entry.path().stem().string(), fs::canonical(entry.path(), none).string()});
        if (!scenes.empty()) break;
    }
    std::sort(scenes.begin(), scenes.end(),
              [](const DemoScene& a, const DemoScene& b) { return a.name < b.name; });
    return scenes;
}

std::string scene_path(const std::string& scene) {
    std::error_code none;
    const fs::path path(scene);
    if (fs::exists(path, none) || path.has_parent_path() || path.has_extension()) return scene;
    const std::vector<DemoScene> known = demo_scenes();
    for (const DemoScene& demo : known)
        if (demo.name == scene) return demo.path;
    throw Error(
        cat(scene, ": no such file, nor a demo scene; ", unknown_name("scene", scene, names_of(known))));
}

}  // namespace drape
