// stability.csv: a row per cell; SI units; what is not known is empty.
#pragma once

#include <string>

#include "study/stability_map.h"

namespace drape {

std::string stability_csv(const StabilityMap& map);

}  // namespace drape
