// Reads a PLY file from end to end for what assimp 5.2.5 does not survive or lets pass: a cut header (it
// hangs), counts the file cannot hold (it allocates), nan, indices out of range, faces of two corners.
#pragma once

#include <string>
#include <string_view>

namespace drape {

// Throws Error "FILE: what is wrong (what is allowed)", in the header and in text bodies "FILE:LINE: ...".
void check_ply(const std::string& path, std::string_view bytes);

}  // namespace drape
