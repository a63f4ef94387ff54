// Stiffness models (fabric.h) on a mesh.
//
// membrane: an edge of rest length l0 shared by triangles of area A gets c = K sum(A) / l0^2 (Van Gelder's
// approximation), that is, an energy of 1/2 K A strain^2 per triangle and edge; altitudes get
// W = ratio K A in the same coin. Edges and altitudes together are stiffer than K, by an amount that depends
// on the pattern and the direction, so K is scaled until the modulus, averaged over directions, is the one
// asked. What remains by direction is reported, not hidden.
//
// The modulus comes from the energy under affine strain e = (exx, eyy, gxy): every spring adds 1/2 W (a .
// e)^2 with a = (dx^2, dy^2, dx dy) for a spring along d. Summed over a surface of area S that is 1/2 S e' C
// e, and a uniaxial pull along theta meets E(theta) = 1 / (s' C^-1 s), s = (cos^2, sin^2, cos sin). For
// irregular meshes, whose vertices shift within the strain, it is an upper bound; for regular patterns it is
// exact.
#include "cloth/network.h"

#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include "base/assert.h"

namespace drape {

namespace {

struct Triangle {
    std::array<Vec3, 3> corner;
    double area;
    Eigen::Vector3d heights;

    Triangle(const Mesh& mesh, int f) {
        for (int k = 0; k < 3; ++k) corner[static_cast<size_t>(k)] = mesh.rest.col(mesh.faces(k, f));
        area = (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm() / 2;
        heights = altitudes_of(corner[0], corner[1], corner[2]);
    }
};

double spring_constant(const Fabric& fabric, double rest_length, double adjacent_area) {
    switch (fabric.stretch_model) {
        case StretchModel::force_per_strain:
            return fabric.stretch / rest_length;
        case StretchModel::spring_constant:
            return fabric.stretch;
        case StretchModel::membrane:
            return fabric.stretch * adjacent_area / (rest_length * rest_length);
    }
    return 0;
}

// W = k h0 of a spring of height h0 within one triangle
double altitude_weight(const Fabric& fabric, double height, double area) {
    switch (fabric.stretch_model) {
        case StretchModel::force_per_strain:
            return fabric.altitude_ratio * fabric.stretch * height;
        case StretchModel::spring_constant:
            return fabric.altitude_ratio * fabric.stretch * height * height;
        case StretchModel::membrane:
            return fabric.altitude_ratio * fabric.stretch * area;
    }
    return 0;
}

double critical_damping(double stiffness, double mass_a, double mass_b) {
    return 2 * std::sqrt(stiffness * mass_a * mass_b / (mass_a + mass_b));
}

// the first axis of a triangle's frame: the x axis laid onto its plane, or z where x stands on it
Eigen::Matrix<double, 3, 2> frame_of(const Triangle& t) {
    const Vec3 normal = (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]).normalized();
    const Vec3 along = std::abs(normal.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitZ();
    Eigen::Matrix<double, 3, 2> frame;
    frame.col(0) = (along - along.dot(normal) * normal).normalized();
    frame.col(1) = normal.cross(Vec3(frame.col(0)));
    return frame;
}

// the linear map from strain (exx, eyy, gxy) to relative lengthening along d
Eigen::Vector3d lengthening(const Eigen::Vector2d& d) {
    const Eigen::Vector2d u = d.normalized();
    return {u.x() * u.x(), u.y() * u.y(), u.x() * u.y()};
}

void add_altitude_modulus(const Fabric& fabric, const TriangleAltitudes& altitudes,
                          const std::array<Eigen::Vector3d, 3>& along_edges, Mat3& sum) {
    const Eigen::Vector3d dilation(1, 1, 0);
    switch (fabric.altitude) {
        case AltitudeMode::none:
        case AltitudeMode::compressed:
            return;  // slack at rest
        case AltitudeMode::all:
        case AltitudeMode::shortest:
            // a height's strain is the dilation less its edge's; `shortest` counts a third of each
            for (int i = 0; i < 3; ++i) {
                const Eigen::Vector3d a = dilation - along_edges[static_cast<size_t>(i)];
                const double w =
                    fabric.altitude == AltitudeMode::all ? altitudes.weight[i] : altitudes.common_weight / 3;
                sum += w * a * a.transpose();
            }
            return;
        case AltitudeMode::blend: {
            const Eigen::Vector3d a = dilation - (along_edges[0] + along_edges[1] + along_edges[2]) / 3;
            sum += altitudes.common_weight * a * a.transpose();
            return;
        }
    }
}

DirectionalModulus modulus_of(const Mesh& mesh, const Topology& topology, const Fabric& fabric,
                              const Network& network) {
    Mat3 sum = Mat3::Zero();
    double area = 0;
    for (int f = 0; f < mesh.triangles(); ++f) {
        const Triangle t(mesh, f);
        const auto frame = frame_of(t);
        area += t.area;
        std::array<Eigen::Vector3d, 3> along_edges;
        for (size_t i = 0; i < 3; ++i) {
            const Vec3 side = t.corner[(i + 2) % 3] - t.corner[(i + 1) % 3];
            along_edges[i] = lengthening(frame.transpose() * side);
            const int e = topology.face_edges(static_cast<int>(i), f);
            const double share = topology.edges[static_cast<size_t>(e)].face_count;
            const double energy_scale = network.edges[static_cast<size_t>(e)].stiffness * side.squaredNorm();
            sum += energy_scale / share * along_edges[i] * along_edges[i].transpose();
        }
        if (!network.altitudes.empty())
            add_altitude_modulus(fabric, network.altitudes[static_cast<size_t>(f)], along_edges, sum);
    }
    const Mat3 compliance = (sum / area).completeOrthogonalDecomposition().pseudoInverse();

    DirectionalModulus modulus;
    constexpr int directions = 72;
    for (int i = 0; i < directions; ++i) {
        const double angle = std::numbers::pi * i / directions;
        const Eigen::Vector3d s = lengthening({std::cos(angle), std::sin(angle)});
        const double value = 1 / s.dot(compliance * s);
        modulus.mean += value / directions;
        if (i == 0 || value < modulus.least) {
            modulus.least = value;
            modulus.least_angle_deg = 180.0 * i / directions;
        }
        if (i == 0 || value > modulus.most) {
            modulus.most = value;
            modulus.most_angle_deg = 180.0 * i / directions;
        }
    }
    return modulus;
}

void scale(Network& network, DirectionalModulus& modulus, double factor) {
    for (Spring& spring : network.edges) spring.stiffness *= factor;
    for (TriangleAltitudes& altitudes : network.altitudes) {
        altitudes.weight *= factor;
        altitudes.common_weight *= factor;
    }
    modulus.mean *= factor;
    modulus.least *= factor;
    modulus.most *= factor;
}

// Springs between the corners that face each other across an inner edge, as stiff as a share of that edge.
std::vector<Spring> bend_springs(const Mesh& mesh, const Topology& topology, const Network& network,
                                 double share) {
    std::vector<Spring> bends;
    for (size_t e = 0; e < topology.edges.size(); ++e) {
        const Edge& edge = topology.edges[e];
        if (edge.face_count != 2 || edge.opposite[0] == edge.opposite[1]) continue;
        const auto [a, b] = std::minmax(edge.opposite[0], edge.opposite[1]);
        const double length = (mesh.rest.col(a) - mesh.rest.col(b)).norm();
        bends.push_back({a, b, length, share * network.edges[e].stiffness, 0});
    }
    return bends;
}

}  // namespace

Eigen::Vector3d altitudes_of(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double doubled_area = (b - a).cross(c - a).norm();
    return {doubled_area / (c - b).norm(), doubled_area / (a - c).norm(), doubled_area / (b - a).norm()};
}

Network build_network(const Mesh& mesh, const Topology& topology, const Fabric& fabric,
                      const Eigen::VectorXd& mass) {
    Network network;
    std::vector<double> adjacent_area(topology.edges.size(), 0);
    for (int f = 0; f < mesh.triangles(); ++f) {
        const Triangle t(mesh, f);
        for (int k = 0; k < 3; ++k) adjacent_area[static_cast<size_t>(topology.face_edges(k, f))] += t.area;
        if (fabric.altitude == AltitudeMode::none || fabric.membrane != MembraneKind::none) continue;
        TriangleAltitudes altitudes;
        altitudes.rest_height = t.heights;
        for (int k = 0; k < 3; ++k) altitudes.weight[k] = altitude_weight(fabric, t.heights[k], t.area);
        altitudes.common_weight = altitude_weight(fabric, t.heights.mean(), t.area);
        network.altitudes.push_back(altitudes);
    }
    for (size_t e = 0; e < topology.edges.size(); ++e) {
        const auto [a, b] = topology.edges[e].vertex;
        const double length = (mesh.rest.col(a) - mesh.rest.col(b)).norm();
        network.edges.push_back({a, b, length, spring_constant(fabric, length, adjacent_area[e]), 0});
    }
    network.modulus = modulus_of(mesh, topology, fabric, network);
    if (fabric.stretch_model == StretchModel::membrane && network.modulus.mean > 0) {
        network.calibration = fabric.stretch / network.modulus.mean;
        scale(network, network.modulus, network.calibration);
    }
    // linear elasticity near rest, whatever the mesh and the direction
    if (fabric.membrane != MembraneKind::none)
        network.modulus = {fabric.stretch, fabric.stretch, fabric.stretch, 0, 0};
    if (fabric.bending_kind == BendingKind::spring)
        network.bends = bend_springs(mesh, topology, network, fabric.bending);
    for (std::vector<Spring>* springs : {&network.edges, &network.bends})
        for (Spring& spring : *springs)
            spring.damping =
                fabric.damping * critical_damping(spring.stiffness, mass[spring.a], mass[spring.b]);
    return network;
}

}  // namespace drape
