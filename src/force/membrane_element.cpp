#include "force/membrane_element.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace drape {

MembraneModuli moduli_of(const Fabric& fabric) {
    const double nu = fabric.membrane_poisson, mu = fabric.stretch / (2 * (1 + nu));
    const double lambda = fabric.stretch * nu / (1 - nu * nu);
    return {mu, lambda, lambda + mu};
}

namespace {

// a and b in a frame of their own, a along its first axis
std::array<Vec2, 2> in_plane(const Vec3& a, const Vec3& b) {
    const double length = a.norm();
    return {Vec2(length, 0), Vec2(a.dot(b) / length, a.cross(b).norm() / length)};
}

// summed as the sweep does, so that a sheet at rest is at rest to the last bit
double squared_length(const Vec3& e) {
    return e.x() * e.x() + e.y() * e.y() + e.z() * e.z();
}

// M_k as (M_11, M_22, sqrt 2 M_12), so that products of two are sums
Eigen::Vector3d metric_of(const Vec2& g, const Vec2& h) {
    return -Eigen::Vector3d(g.x() * h.x(), g.y() * h.y(), (g.x() * h.y() + g.y() * h.x()) / std::sqrt(2.0));
}

}  // namespace

Mat3 edge_products(const std::array<Vec3, 3>& edge, const Eigen::Vector3d& weight) {
    // grad Q_k is 2 e_k at corner k + 2 and -2 e_k at corner k + 1
    Mat3 products;
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3, last = (k + 2) % 3;
        const auto& e = edge[static_cast<size_t>(k)];
        products(k, k) = 4 * (weight[next] + weight[last]) * e.squaredNorm();
        products(k, next) = products(next, k) = -4 * weight[last] * e.dot(edge[static_cast<size_t>(next)]);
    }
    return products;
}

MembraneElement membrane_element(const Cloth& cloth, int f) {
    MembraneElement element;
    std::array<Vec3, 3> rest, edge;
    Eigen::Vector3d inverse_mass;
    for (size_t k = 0; k < 3; ++k) {
        const int vertex = cloth.mesh.faces(static_cast<int>(k), f);
        element.corner[k] = cloth.first + vertex;
        rest[k] = cloth.mesh.rest.col(vertex);
        inverse_mass[static_cast<int>(k)] = 1 / cloth.mass[vertex];
    }
    for (size_t k = 0; k < 3; ++k) {
        edge[k] = rest[(k + 2) % 3] - rest[(k + 1) % 3];
        element.squared[static_cast<int>(k)] = squared_length(edge[k]);
    }
    const auto [a, b] = in_plane(rest[1] - rest[0], rest[2] - rest[0]);
    const double doubled_area = a.x() * b.y();
    element.area = doubled_area / 2;
    element.slope[1] = Vec2(b.y(), -b.x()) / doubled_area;
    element.slope[2] = Vec2(0, a.x()) / doubled_area;
    element.slope[0] = -element.slope[1] - element.slope[2];

    const MembraneModuli moduli = moduli_of(cloth.fabric);
    Mat3 metrics;
    for (int k = 0; k < 3; ++k) {
        metrics.col(k) = metric_of(element.slope[static_cast<size_t>((k + 1) % 3)],
                                   element.slope[static_cast<size_t>((k + 2) % 3)]);
        element.trace[k] = metrics(0, k) + metrics(1, k);
    }
    element.coupling = element.area * (moduli.mu * metrics.transpose() * metrics +
                                       moduli.lambda / 2 * element.trace * element.trace.transpose());
    if (cloth.fabric.damping > 0) {
        // omega^2 of the triangle alone: eigenvalues of the products times d2E/dQ2 = T / 2
        const Mat3 root = (element.coupling / 2).llt().matrixL();
        const Mat3 modes = root.transpose() * edge_products(edge, inverse_mass) * root;
        const double fastest_squared =
            Eigen::SelfAdjointEigenSolver<Mat3>(modes, Eigen::EigenvaluesOnly).eigenvalues()[2];
        element.relaxation = 2 * cloth.fabric.damping / std::sqrt(fastest_squared);
    }
    return element;
}

MembranePose membrane_pose(const MembraneElement& element, In x) {
    MembranePose pose;
    for (size_t k = 0; k < 3; ++k) {
        pose.edge[k] = x.col(element.corner[(k + 2) % 3]) - x.col(element.corner[(k + 1) % 3]);
        pose.squared[static_cast<int>(k)] = squared_length(pose.edge[k]);
    }
    pose.doubled_area = pose.edge[1].cross(pose.edge[2]).norm();
    return pose;
}

MembraneResponse stvk_response(const MembraneElement& element, const MembranePose& pose) {
    const Eigen::Vector3d change = pose.squared - element.squared;
    const Eigen::Vector3d tension = element.coupling * change;
    return {change.dot(tension) / 4, tension, element.coupling};
}

MembraneResponse neo_hookean_response(const MembraneElement& element, const MembranePose& pose,
                                      const MembraneModuli& moduli) {
    const double area_stretch = pose.doubled_area / (2 * element.area), area = element.area;
    MembraneResponse response;
    response.energy = area * (moduli.mu / 2 * (element.trace.dot(pose.squared) - 2 * area_stretch) +
                              moduli.kappa / 2 * (area_stretch - 1) * (area_stretch - 1));
    response.tension = moduli.mu * area * element.trace;
    response.change.setZero();
    if (pose.doubled_area == 0) return response;
    const double d = pose.doubled_area, push = moduli.kappa * (area_stretch - 1) - moduli.mu;
    const Eigen::Vector3d slope =
        (Eigen::Vector3d::Constant(pose.squared.sum()) - 2 * pose.squared) / 2;  // b_k
    response.tension += push / (2 * d) * slope;
    const Mat3 of_slope = Mat3::Constant(0.5) - Mat3::Identity();  // db_k/dQ_j
    response.change =
        (moduli.kappa / (8 * area * d * d) - push / (4 * d * d * d)) * slope * slope.transpose() +
        push / (2 * d) * of_slope;
    return response;
}

}  // namespace drape
