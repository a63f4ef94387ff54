// Reads a scene file (TOML; the README is its reference). Whatever is wrong ends in one Error that says
// where.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/description.h"

namespace drape {

// `overrides` are KEY=VALUE as --set takes them (overrides.h). Meshes are not opened yet.
// Throws Error "FILE:LINE:COL: what is wrong (what is allowed)".
SceneDescription read_scene(const std::string& path, const std::vector<std::string>& overrides = {});

// The same of a scene's text that is at hand; `path` says where it would stand.
SceneDescription read_scene_text(std::string_view text, const std::string& path,
                                 const std::vector<std::string>& overrides = {});

}  // namespace drape
