// Positions of a glTF cache.
#pragma once

#include <string>
#include <string_view>

#include "io/cache_reader.h"

namespace drape {

// `bytes` of the file at `path`. Throws Error naming it where it is not a glTF binary of one mesh with a
// morph target per frame, as drape writes it.
Cache read_glb(const std::string& path, std::string_view bytes);

}  // namespace drape
