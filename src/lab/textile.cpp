#include "lab/textile.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "lab/elasticity.h"
#include "mesh/pattern.h"

namespace drape {

namespace {

constexpr std::array bands{DrapeBand{"silk", 0.2, 0.4}, DrapeBand{"cotton", 0.6, 0.76},
                           DrapeBand{"wool", 0.4, 0.7}, DrapeBand{"denim", 0.7, 0.9}};

constexpr int pulled_divisions = 24;  // of the sheet that is pulled

}  // namespace

FabricMeasures measure_fabric(std::string_view name, const Fabric& fabric, double edge) {
    FabricMeasures measures{std::string(name), fabric, measure_bending_length(fabric), 0, 0, 0, {}};
    const Elasticity sheet =
        measure_elasticity(make_pattern("alternating", {1, 1, pulled_divisions, pulled_divisions}), fabric);
    measures.warp = pull / sheet.stretch_modulus(0);
    measures.weft = pull / sheet.stretch_modulus(std::numbers::pi / 2);
    measures.bias = pull / sheet.stretch_modulus(std::numbers::pi / 4);
    measures.drape = drape_disc(fabric, edge);
    return measures;
}

std::optional<DrapeBand> drape_band(std::string_view fabric) {
    for (const DrapeBand& band : bands)
        if (band.fabric == fabric) return band;
    return std::nullopt;
}

}  // namespace drape
