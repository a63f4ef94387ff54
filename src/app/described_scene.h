// A scene with the command line's wishes in it.
#pragma once

#include "app/options.h"
#include "scene/description.h"

namespace drape {

// Throws Error where file or flags are wrong, or contradict each other.
SceneDescription described_scene(const RunOptions& options);

}  // namespace drape
