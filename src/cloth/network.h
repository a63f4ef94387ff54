// The spring network of a cloth: what a fabric's few numbers become on a given mesh. Nothing but this file
// turns a fabric's stiffness into spring constants.
#pragma once

#include <vector>

#include "cloth/fabric.h"
#include "mesh/mesh.h"
#include "mesh/topology.h"

namespace drape {

// A spring between two vertices: E = 1/2 c (l - l0)^2; with k = c l0 that is 1/2 k l0 (l/l0 - 1)^2.
struct Spring {
    int a = 0, b = 0;        // vertices of the cloth, a < b
    double rest_length = 0;  // l0 [m]; 0 is allowed
    double stiffness = 0;    // c [N/m]
    double damping = 0;      // force per speed of lengthening [N s/m]
};

// What resists a triangle's collapse: E = 1/2 W strain^2 for each altitude (modes in force/altitude_*.h).
// For one altitude of rest height h0 and force per strain k, W = k h0.
struct TriangleAltitudes {
    Eigen::Vector3d rest_height;  // h_i0, from corner i to the opposite edge [m]
    Eigen::Vector3d weight;       // W of each altitude alone, for mode `all` [J]
    double common_weight = 0;     // W of the triangle as one, for `shortest`, `compressed`, `blend` [J]
};

// Young's modulus times thickness of the whole network by direction, linearised at rest under affine strain.
struct DirectionalModulus {
    double mean = 0, least = 0, most = 0;            // [N/m]
    double least_angle_deg = 0, most_angle_deg = 0;  // from the first axis of the surface, see network.cpp
};

struct Network {
    // With a membrane (MembraneKind) no force: then they tell lengths, and how stiff springs in its place
    // would be.
    std::vector<Spring> edges;
    std::vector<TriangleAltitudes>
        altitudes;              // one per triangle; empty for AltitudeMode::none, or a membrane
    std::vector<Spring> bends;  // BendingKind::spring only
    DirectionalModulus modulus;
    double calibration =
        1;  // membrane model: factor on Van Gelder's constants so that modulus.mean is as asked
};

// `mass` per vertex [kg] sets damping: b = 2 zeta sqrt(c m_red), m_red = m_a m_b / (m_a + m_b).
Network build_network(const Mesh& mesh, const Topology& topology, const Fabric& fabric,
                      const Eigen::VectorXd& mass);

// Altitudes of the triangle (a, b, c): from each corner to the line through the other two [m].
Eigen::Vector3d altitudes_of(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace drape
