// Scenes written down in a test: read them, or get the one line that refuses them.
#pragma once

#include <string>
#include <vector>

#include "scene/description.h"

namespace drape::test {

// A scene with one cloth in three lines; `rest` starts at line 4, column 1, inside that cloth's table.
std::string with_cloth(const std::string& rest);

// What read_scene makes of the text, written to "scene.toml" in a fresh folder.
SceneDescription scene_of(const std::string& text, const std::vector<std::string>& overrides = {});

// The message of the Error it throws, from "scene.toml" on; "" if it throws none.
std::string error_of(const std::string& text, const std::vector<std::string>& overrides = {});

}  // namespace drape::test
