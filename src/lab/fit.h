// Spring constants from what a textile laboratory measured: a stretch curve and a bending length.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lab/experiment.h"

namespace drape {

struct FitRequest {
    std::string curve;          // a CSV file: strain [-], force per width [N/m]
    double bending_length = 0;  // [m]
    double density = 0;         // [kg/m^2]
};

struct StretchCurve {
    std::vector<std::array<double, 2>> samples;  // (strain, force per width [N/m])
};

// Lines of two numbers, perhaps after a line of names; blank lines and what follows # do not count. Throws
// Error "FILE:LINE: ...".
StretchCurve read_stretch_curve(const std::string& path);
StretchCurve parse_stretch_curve(const std::string& text, const std::string& path);

// A fabric whose sheets, cut by alternating diagonals, stretch along warp as the curve's straight line
// through the origin and bend to this length.
struct FabricFit {
    double modulus = 0;               // of that line [N/m]
    double off = 0;                   // RMS of the curve from it, over its largest force [-]
    double stretch = 0, bending = 0;  // what a scene's fabric says for it [N/m], [N m]
    double virtual_modulus = 0;       // the fabric's own, measured on a virtual sheet [N/m]
    double virtual_length = 0;        // ... and its bending length [m]
};
FabricFit fit_fabric(const StretchCurve& curve, double bending_length, double density);

// As a chapter of the laboratory's page.
LabResult run_fit(const FitRequest& request);

}  // namespace drape
