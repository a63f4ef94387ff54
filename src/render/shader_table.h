// Every file of shaders/, embedded by the build (embed_shaders.cmake writes the definition).
#pragma once

#include <span>

#include "render/shader.h"

namespace drape {

std::span<const ShaderFile> shader_table();

}  // namespace drape
