// Reads a scene file (TOML; the README is its reference). Whatever is wrong ends in one Error that says
// where.
#pragma once

#include <string>
#include <vector>

#include "scene/description.h"

namespace drape {

// `overrides` are KEY=VALUE as --set takes them (overrides.h). Meshes are not opened yet.
// Throws Error "FILE:LINE:COL: what is wrong (what is allowed)".
SceneDescription read_scene(const std::string& path, const std::vector<std::string>& overrides = {});

}  // namespace drape
