// Fabric presets on the laboratory's page.
#pragma once

#include "lab/experiment.h"

namespace drape {

// Those named, or all. Throws Error naming the nearest known one.
LabResult measure_fabrics(std::span<const std::string> names);

}  // namespace drape
