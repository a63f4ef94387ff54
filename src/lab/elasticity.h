// How stiff a sheet is as a whole, by direction: the elastic matrix of a mesh, measured.
#pragma once

#include <vector>

#include "cloth/model.h"

namespace drape {

// Plane elasticity, stress (sxx, syy, sxy) = C (exx, eyy, gxy), with axes x and z of the sheet. [N/m]
struct Elasticity {
    Mat3 stiffness = Mat3::Zero();  // C

    // E of a pull along `angle` [rad] alone: 1 / E = s' C^-1 s, s = (cos^2, sin^2, cos sin)
    double stretch_modulus(double angle) const;
    // G of shear stress along `angle` and across it: 1 / G = t' C^-1 t, t = (-2 cos sin, 2 cos sin,
    // cos^2 - sin^2)
    double shear_modulus(double angle) const;
};

// A modulus over all directions, from 0 to 180 degrees.
struct DirectionCurve {
    std::vector<double> angle_deg, value;  // [degrees], [N/m]
    double least = 0, most = 0, mean = 0;  // [N/m]
    double ratio() const { return most / least; }
};

DirectionCurve stretch_curve(const Elasticity& elasticity);
DirectionCurve shear_curve(const Elasticity& elasticity);

// (exx, eyy, gxy) of a triangle of a sheet in the plane y = 0 whose vertices make a small move.
Eigen::Vector3d strain_of(const Mesh& mesh, int triangle, const Points& move);

// Where all vertices of such a sheet go when those `held` make each of these small moves [m]: the others come
// to rest. Linear, in the cloth's plane.
std::vector<Points> settle(const Model& free, const std::vector<int>& held, std::vector<Points> moves);

// The virtual test: the border of a flat sheet in the plane y = 0 is moved by a small affine strain, the
// vertices inside come to rest, and the energy and the strain in the middle of the sheet, away from the
// border, are those of a uniform material. Linear: the forces' stiffness matrices at rest.
Elasticity measure_elasticity(const Mesh& sheet, const Fabric& fabric);

}  // namespace drape
