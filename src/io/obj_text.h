// Reads the text of an OBJ file for what assimp loses or lets pass: the order and full precision of its `v`
// lines, numbers written like `.5`, nan, indices out of range, faces of two corners; each with its line.
#pragma once

#include <string>
#include <string_view>

#include "base/points.h"

namespace drape {

struct ObjText {
    Points vertices;  // a column per `v` line
    // The same surface for assimp to read: v, vt and f only, one object, indices counted from the start,
    // plain numbers. The colour of each `v` is its mark (assimp_import.h), so that assimp's vertices find
    // back to ours.
    std::string plain;
    int points_lines = 0;  // `p` and `l` elements left out
};

// Throws Error "FILE:LINE: what is wrong (what is allowed)".
ObjText read_obj(const std::string& path, std::string_view text);

}  // namespace drape
