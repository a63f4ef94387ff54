#include "cloth/fabric.h"

#include <array>

#include "base/names.h"

namespace drape {

namespace {

// Density [kg/m^3], thickness [mm], Young's modulus [MPa], Poisson's ratio, as measured tables give them; a
// thin plate of them weighs rho t, stretches with E t and bends with B = E t^3 / (12 (1 - nu^2)).
constexpr Fabric from_table(double density, double thickness_mm, double modulus_mpa, double poisson,
                            double damping) {
    const double t = thickness_mm * 1e-3, modulus = modulus_mpa * 1e6;
    Fabric fabric;
    fabric.density = density * t;
    fabric.thickness = t;
    fabric.stretch_model = StretchModel::membrane;
    fabric.stretch = modulus * t;
    fabric.altitude = AltitudeMode::blend;
    fabric.membrane_poisson = poisson;
    fabric.bending_kind = BendingKind::plate;
    fabric.bending = modulus * t * t * t / (12 * (1 - poisson * poisson));
    fabric.poisson = poisson;
    fabric.damping = damping;
    return fabric;
}

constexpr std::string_view codimensional =
    "Codimensional Incremental Potential Contact (2021), table of calibrated cloth; damping is drape's "
    "choice";

constexpr std::array presets{
    FabricPreset{"cotton", "plain woven cotton, 0.15 kg/m^2", codimensional,
                 from_table(472.6, 0.318, 0.821, 0.243, 0.05)},
    FabricPreset{"wool", "woven wool, 0.23 kg/m^2", codimensional,
                 from_table(413.4, 0.568, 0.170, 0.277, 0.05)},
    FabricPreset{"wool_lycra", "wool with lycra, 0.18 kg/m^2, stretchy", codimensional,
                 from_table(543.3, 0.328, 0.076, 0.071, 0.05)},
    FabricPreset{"polyester", "woven polyester, 0.16 kg/m^2", codimensional,
                 from_table(653.2, 0.252, 0.478, 0.381, 0.05)},
};

}  // namespace

std::span<const FabricPreset> fabric_presets() {
    return presets;
}

const Fabric& fabric_preset(std::string_view name) {
    return find_named(presets, "fabric", name).fabric;
}

}  // namespace drape
