// Sheets to bend, and surfaces to bend them to.
#pragma once

#include <functional>
#include <string>

#include "cloth/model.h"
#include "support/cloths.h"

namespace drape::test {

Fabric bending_fabric(BendingKind kind, double bending = 1);

// Rows of equilateral triangles, every other row shifted by half a side; the same area everywhere.
Mesh equilateral_sheet(int divisions);

struct Sheet {
    std::string name;
    Mesh mesh;
};

// Every pattern, regular and jittered, and the equilateral one.
std::vector<Sheet> every_sheet(int divisions);

// The flat sheet lifted to y = height(x, z).
Points lifted(const Mesh& mesh, const std::function<double(double, double)>& height);

// The flat sheet rolled without stretch onto a cylinder of `radius`, curved along the direction at
// `angle_deg`.
Points rolled(const Mesh& mesh, double radius, double angle_deg);

double rest_area(const Cloth& cloth);

}  // namespace drape::test
