// A fabric measured as a textile laboratory would: cantilever, strip pulled along three directions, drape.
#pragma once

#include <optional>
#include <string>

#include "lab/cantilever.h"
#include "lab/cusick.h"

namespace drape {

inline constexpr double pull = 19.6133;  // [N/m]: 20 gf/cm, the second of the FAST system's three loads

struct FabricMeasures {
    std::string name;
    Fabric fabric;
    BendingLength bending;
    double warp = 0, weft = 0, bias = 0;  // strain under `pull`, as its stiffness at rest tells
    CusickDrape drape;
};

// `edge` [m] of the drape test's triangles.
FabricMeasures measure_fabric(std::string_view name, const Fabric& fabric, double edge);

// Drape coefficients that are usually quoted for such cloth; none for most presets.
struct DrapeBand {
    std::string_view fabric;
    double least, most;  // [-]
};
std::optional<DrapeBand> drape_band(std::string_view fabric);

}  // namespace drape
