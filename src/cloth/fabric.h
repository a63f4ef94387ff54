// A fabric: what a user says about cloth, before it becomes spring constants (network.h).
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace drape {

// What the number given as stretch stiffness means.
//   force_per_strain  k [N], the same for every spring. E = 1/2 k l0 (l/l0 - 1)^2. The lecture notes' own;
//   its
//                     hazard: where the mesh is finer the cloth is stronger.
//   spring_constant   k [N/m], the same for every spring. E = 1/2 k (l - l0)^2.
//   membrane          E t [N/m], Young's modulus times thickness: a property of the fabric, not of the mesh.
//                     Spread over edges by area (Van Gelder), then calibrated with the altitude springs.
enum class StretchModel { force_per_strain, spring_constant, membrane };

enum class AltitudeMode { none, all, shortest, compressed, blend };

// What resists stretch and shear: springs along edges and altitudes, or finite elements (force/membrane.h),
// which take StretchModel::membrane alone.
//   none         springs
//   stvk         St. Venant-Kirchhoff: linear in Green's strain, weak under strong compression
//   neo_hookean  resists compression to the end
enum class MembraneKind { none, stvk, neo_hookean };

//   plate   Morley's triangles; exact for quadratic surfaces on every mesh
//   hinge   dihedral angle against its rest angle, per inner edge
//   spring  a plain spring between the corners opposite an inner edge
enum class BendingKind { none, plate, hinge, spring };

struct Fabric {
    double density = 0.1;     // mass per area [kg/m^2]
    double thickness = 1e-3;  // of the fabric [m]; contact keeps surfaces apart by it
    StretchModel stretch_model = StretchModel::membrane;
    double stretch = 100;  // [N], [N/m] or [N/m], see StretchModel
    AltitudeMode altitude = AltitudeMode::none;
    double altitude_ratio = 1;        // altitude stiffness over edge stiffness [-]
    double compressed_beyond = 0.25;  // AltitudeMode::compressed resists beyond this fraction [-]
    MembraneKind membrane = MembraneKind::none;
    double membrane_poisson = 0.3;  // of finite elements [-]
    BendingKind bending_kind = BendingKind::none;
    double bending =
        0;  // bending rigidity B [N m]; for BendingKind::spring a fraction of the stretch stiffness
    double poisson = 0.3;         // of bending, plates only [-]
    double damping = 0;           // ratio of critical for a single spring, [-]
    double friction = 0.3;        // Coulomb's coefficient of cloth on cloth [-]
    double weighed_in = 9.80665;  // gravity in which its bending length is measured [m/s^2]
};

struct FabricPreset {
    std::string_view name;
    std::string_view summary;
    std::string_view source;  // where the figures come from
    Fabric fabric;
};

std::span<const FabricPreset> fabric_presets();

// Throws Error naming the nearest known preset.
const Fabric& fabric_preset(std::string_view name);

}  // namespace drape
