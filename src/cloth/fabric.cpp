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

// Woven of yarns that slide on each other, cloth bends otherwise than such a plate: four to thirteen times as
// hard in tests of its weight.
constexpr Fabric bent_as_tested(Fabric fabric, double bending) {
    fabric.bending = bending;
    return fabric;
}

// Weight per area [kg/m^2], thickness [mm], stretch modulus [N/m] and bending rigidity [N m], each measured
// by itself: cloth is no plate of one material. Woven cloth hardly stretches along its threads, but drapes by
// shear: of one modulus for all directions that on the bias is the one to take.
constexpr Fabric measured(double density, double thickness_mm, double stretch, double bending) {
    Fabric fabric;
    fabric.density = density;
    fabric.thickness = thickness_mm * 1e-3;
    fabric.stretch_model = StretchModel::membrane;
    fabric.stretch = stretch;
    fabric.altitude = AltitudeMode::blend;
    fabric.bending_kind = BendingKind::plate;
    fabric.bending = bending;
    fabric.damping = 0.05;
    return fabric;
}

constexpr std::array presets{
    FabricPreset{"cotton", "plain woven cotton, 0.15 kg/m^2",
                 "weight, thickness, stretch: Codimensional Incremental Potential Contact (2021), table of "
                 "calibrated cloth; bending: median of the 47 fabrics of 0.13 to 0.17 kg/m^2 in Feng et al. "
                 "(2022); damping is drape's choice",
                 bent_as_tested(from_table(472.6, 0.318, 0.821, 0.243, 0.05), 9.51e-6)},
    FabricPreset{"wool", "woven wool, 0.23 kg/m^2",
                 "weight, thickness, stretch: Codimensional Incremental Potential Contact (2021), table of "
                 "calibrated cloth; bending: median of the 82 fabrics of 0.21 to 0.26 kg/m^2 in Feng et al. "
                 "(2022); damping is drape's choice",
                 bent_as_tested(from_table(413.4, 0.568, 0.170, 0.277, 0.05), 17.8e-6)},
    FabricPreset{
        "wool_lycra", "wool with lycra, 0.18 kg/m^2, stretchy",
        "Codimensional Incremental Potential Contact (2021), table of calibrated cloth; bending is that of a "
        "plate of the same modulus; damping is drape's choice",
        from_table(543.3, 0.328, 0.076, 0.071, 0.05)},
    FabricPreset{"polyester", "woven polyester, 0.16 kg/m^2",
                 "weight, thickness, stretch: Codimensional Incremental Potential Contact (2021), table of "
                 "calibrated cloth; bending: median of the 79 fabrics of 0.14 to 0.19 kg/m^2 in Feng et al. "
                 "(2022); damping is drape's choice",
                 bent_as_tested(from_table(653.2, 0.252, 0.478, 0.381, 0.05), 9.96e-6)},
    FabricPreset{
        "silk", "light filament silk (10 momme), 0.04 kg/m^2",
        "bending: lower quartile of the 23 fabrics of 0.035 to 0.055 kg/m^2 in Feng et al. (2022), "
        "cantilever tests of 618 fabrics; stretch: on the bias, four times the shear stiffness, of a woven "
        "polyester of Wang et al. (2011) in its place; thickness and damping are drape's choice",
        measured(0.0434, 0.12, 77, 1.01e-6)},
    FabricPreset{
        "denim", "11 oz cotton denim, 0.32 kg/m^2",
        "weight and stretch (on the bias, four times the shear stiffness): 11oz-black-denim of Wang et al. "
        "(2011); bending: upper quartile of the 47 fabrics of 0.29 to 0.36 kg/m^2 in Feng et al. (2022); "
        "thickness: mean of six denims, J. of Textiles 2016, 4614168; damping is drape's choice",
        measured(0.324, 0.99, 214, 44.4e-6)},
    FabricPreset{
        "canvas", "12 oz cotton canvas, 0.41 kg/m^2",
        "bending: upper quartile of the 53 fabrics of 0.37 to 0.45 kg/m^2 in Feng et al. (2022); stretch: on "
        "the bias, of the cotton and polyester trousers cloth of Wang et al. (2011); thickness and damping "
        "are drape's choice",
        measured(0.407, 0.8, 419, 48.3e-6)},
    FabricPreset{
        "paper", "copy paper, 0.07 kg/m^2",
        "0.075 kg/m^2 and 0.102 mm of a lecture's paper characteristics; Young's modulus of 5 GPa of "
        "ARCSim's paper; Poisson's ratio and damping are drape's choice",
        from_table(735, 0.102, 5000, 0.3, 0.05)},
    FabricPreset{
        "rubber", "a millimetre of natural rubber, 0.95 kg/m^2",
        "MatWeb, vulcanized natural rubber: 950 kg/m^3, shear modulus 0.5 MPa, taken as incompressible; "
        "damping is drape's choice",
        from_table(950, 1, 1.5, 0.5, 0.05)},
};

}  // namespace

std::span<const FabricPreset> fabric_presets() {
    return presets;
}

const Fabric& fabric_preset(std::string_view name) {
    return find_named(presets, "fabric", name).fabric;
}

}  // namespace drape
