// Which vertices a scene's pin means.
#pragma once

#include "cloth/model.h"
#include "scene/description.h"

namespace drape {

// `cloth` as it is in the model, `start` the positions of all vertices at the start: there its vertices are
// held. Throws Error at the pin's place if it matches nothing.
PinGroup find_pins(const PinDescription& pin, const Cloth& cloth, In start);

}  // namespace drape
