#include "scene/description.h"

#include <cmath>
#include <filesystem>

namespace drape {

int SceneDescription::frames() const {
    return static_cast<int>(std::lround(duration * frame_rate));
}

std::string SceneDescription::path_to(const std::string& relative) const {
    return (std::filesystem::path(folder) / relative).lexically_normal().string();
}

}  // namespace drape
