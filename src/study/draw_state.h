// How a study gets to see what it measures.
#pragma once

#include <functional>

#include "base/image.h"
#include "cloth/state.h"

namespace drape {

// Draws a state of the scene; empty where drape was built without its renderer.
using DrawState = std::function<Image(const State&)>;

}  // namespace drape
