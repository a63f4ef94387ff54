// A scene as TOML with every default written out: what `drape inspect` prints.
#pragma once

#include <string>

#include "scene/description.h"

namespace drape {

// Reading it back (from the same folder) gives the same scene.
std::string scene_text(const SceneDescription& scene);

}  // namespace drape
