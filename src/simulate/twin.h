// Twin runs: two starts that no measurement could tell apart. How far they end apart is the predictability
// floor, below which no statement about an error means anything.
#pragma once

#include "cloth/model.h"

namespace drape {

inline constexpr double twin_offset = 1e-12;  // [m]

// Every free vertex moved by twin_offset, each its own way, always the same.
State moved_a_little(const Model& model, State start);

}  // namespace drape
