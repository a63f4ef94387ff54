#include "support/every_force.h"

#include "base/error.h"
#include "support/membranes.h"

namespace drape::test {

std::vector<Fabric> every_fabric() {
    std::vector<Fabric> fabrics;
    for (const StretchModel model :
         {StretchModel::force_per_strain, StretchModel::spring_constant, StretchModel::membrane}) {
        for (const AltitudeMode mode :
             {AltitudeMode::all, AltitudeMode::shortest, AltitudeMode::compressed, AltitudeMode::blend}) {
            for (const BendingKind kind : {BendingKind::plate, BendingKind::hinge, BendingKind::spring}) {
                Fabric fabric = bare_springs(50);
                fabric.stretch_model = model;
                fabric.altitude = mode;
                fabric.altitude_ratio = 0.7;
                fabric.compressed_beyond = 0.02;
                fabric.bending_kind = kind;
                fabric.bending = kind == BendingKind::spring ? 0.1 : 0.5;
                fabric.damping = 0.1;
                fabrics.push_back(fabric);
            }
        }
    }
    for (const MembraneKind kind : {MembraneKind::stvk, MembraneKind::neo_hookean}) {
        Fabric fabric = membrane_fabric(kind, 50, 0.2);
        fabric.bending_kind = BendingKind::plate;
        fabric.bending = 0.5;
        fabric.damping = 0.1;
        fabrics.push_back(fabric);
    }
    return fabrics;
}

namespace {

// a fabric has springs along edges and altitudes, or a membrane
bool is_replaced(std::string_view name, MembraneKind membrane) {
    if (membrane == MembraneKind::none) return name == "membrane";
    return name == "edge springs" || name == "altitude springs";
}

}  // namespace

std::vector<Case> every_force(const Cloth& cloth) {
    Surroundings world;
    world.air = {.drag = 0.1, .aerodynamic = true, .wind = {3, 0, 1}, .gust_strength = 0.3};
    std::vector<Case> cases;
    for (const ForceKind& kind : force_kinds()) {
        MadeForce made = kind.make(cloth, world);
        if (is_replaced(kind.name, cloth.fabric.membrane) && !made.force) continue;
        if (!made.force) throw Error(cat("no force of ", kind.name));
        const bool internal = kind.name != "gravity" && kind.name != "air drag" && kind.name != "wind";
        cases.push_back({std::string(kind.name), std::move(made.force), internal});
    }
    return cases;
}

}  // namespace drape::test
