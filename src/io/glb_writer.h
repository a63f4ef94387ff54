// A position cache as a glTF 2.0 binary: the cloth, its UVs and colour, and a morph target for every frame.
#pragma once

#include <memory>

#include "base/colour.h"
#include "io/cache_writer.h"

namespace drape {

// Throws Error for an unwritable place, or where the file would be larger than 4 GiB, the most its header can
// tell. Samples go straight to the file; two in single precision are kept.
std::unique_ptr<CacheWriter> make_glb_writer(const std::string& path, const Mesh& mesh, double frame_rate,
                                             int samples, const Colour& colour);

}  // namespace drape
