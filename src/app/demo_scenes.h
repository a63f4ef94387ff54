// The scenes that come with drape: assets/scenes beside the sources, share/drape/scenes where it is
// installed.
#pragma once

#include <string>
#include <vector>

namespace drape {

struct DemoScene {
    std::string name, path;
};

// Sorted by name; empty if the program stands alone.
std::vector<DemoScene> demo_scenes();

// `scene` itself if there is such a file or it looks like a path; else the demo scene of that name.
// Throws Error naming the nearest one.
std::string scene_path(const std::string& scene);

}  // namespace drape
