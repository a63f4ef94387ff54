// Scenes on which it is checked that a tolerance holds, a row each.
#pragma once

#include <span>

#include "simulate/simulation.h"

namespace drape::bench {

enum class Held { corners, edge, nowhere, carried };  // carried: by two corners that move and turn

struct ToleranceScene {
    const char* name = "";
    int side = 33;            // vertices
    double stiffness = 500;   // K of every edge spring [N/m]
    double duration = 0.5;    // [s]
    double tolerance = 1e-3;  // asked [m]
    double damping = 0;       // ratio of critical
    BendingKind bending_kind = BendingKind::none;
    double bending = 0;  // [N m]
    AltitudeMode altitude = AltitudeMode::none;
    Held held = Held::corners;
    double wind = 0, gust = 0;  // [m/s], [-]; 0: no air
    double drag = 0;            // linear, of the air [kg/s per m^2]
    const char* obstacle = "";  // "sphere" below the sheet, "plane" under its hem; "" = none
    double friction = 0;
};

std::span<const ToleranceScene> tolerance_scenes();

Setup setup_of(const ToleranceScene& scene);

}  // namespace drape::bench
