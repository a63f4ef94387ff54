// Where an earlier run was curved: what an adaptive pattern is finer by.
#pragma once

#include <string>
#include <vector>

#include "mesh/size_field.h"

namespace drape {

// `mesh` is a file with UVs, which say where on the pattern its vertices are; `positions`, if any, a cache
// or another file of its vertices: every place counts with the most it was ever curved in one of its samples.
// Throws Error.
std::vector<CurvedPlace> curved_places(const std::string& mesh, const std::string& positions);

}  // namespace drape
