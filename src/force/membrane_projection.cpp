#include "force/membrane_projection.h"

#include <Eigen/Cholesky>

#include "force/colouring.h"

namespace drape {

namespace {

Eigen::Vector3d inverse_masses(const MembraneElement& element, const WeightedPoints& x) {
    return {x(3, element.corner[0]), x(3, element.corner[1]), x(3, element.corner[2])};
}

// x_v -= w_v sum_k y_k grad_v Q_k
void pull_edges(const MembraneElement& element, const MembranePose& pose, const Eigen::Vector3d& y,
                WeightedPoints& x) {
    for (size_t k = 0; k < 3; ++k) {
        const size_t next = (k + 1) % 3, last = (k + 2) % 3;
        const Vec3 gradient =
            2 * (y[static_cast<int>(next)] * pose.edge[next] - y[static_cast<int>(last)] * pose.edge[last]);
        const int vertex = element.corner[k];
        x.col(vertex).head<3>() -= x(3, vertex) * gradient;
    }
}

}  // namespace

MembraneProjection::MembraneProjection(const std::vector<MembraneElement>& elements, MembraneKind kind,
                                       const MembraneModuli& moduli)
    : kind_(kind), moduli_(moduli) {
    std::vector<int> corners;
    for (const MembraneElement& element : elements)
        corners.insert(corners.end(), element.corner.begin(), element.corner.end());
    for (const int i : colour_elements(corners, 3).order) {
        const MembraneElement& element = elements[static_cast<size_t>(i)];
        triangles_.push_back({element, 2 * element.coupling.inverse()});
    }
}

void MembraneProjection::relax_edges(const Triangle& triangle, double h, WeightedPoints& x) const {
    const MembraneElement& element = triangle.element;
    const MembranePose pose = membrane_pose(element, x.topRows<3>());
    const Mat3 system = triangle.compliance / (h * h) + edge_products(pose.edge, inverse_masses(element, x));
    pull_edges(element, pose, system.llt().solve(pose.squared - element.squared), x);
}

void MembraneProjection::relax_shape(const MembraneElement& element, double h, WeightedPoints& x) const {
    Vec3 a = Vec3::Zero(), b = Vec3::Zero();
    double products = 0;
    for (size_t k = 0; k < 3; ++k) {
        const auto corner = x.col(element.corner[k]);
        // differences to one corner: no large terms that cancel far from the origin
        const Vec3 arm = (corner - x.col(element.corner[0])).head<3>();
        a += element.slope[k].x() * arm;
        b += element.slope[k].y() * arm;
        products += corner[3] * element.slope[k].squaredNorm();
    }
    const Vec3 normal = a.cross(b);
    if (normal.isZero(0)) return;
    const Vec3 e1 = a.normalized(), e2 = normal.normalized().cross(e1);
    const Vec2 y =
        Vec2(a.dot(e1) - b.dot(e2), b.dot(e1)) / (1 / (h * h * moduli_.mu * element.area) + products);
    for (size_t k = 0; k < 3; ++k) {
        const Vec2& g = element.slope[k];
        const int vertex = element.corner[k];
        x.col(vertex).head<3>() -=
            x(3, vertex) * ((y[0] * g.x() + y[1] * g.y()) * e1 + (y[1] * g.x() - y[0] * g.y()) * e2);
    }
}

void MembraneProjection::relax_area(const MembraneElement& element, double h, WeightedPoints& x) const {
    const MembranePose pose = membrane_pose(element, x.topRows<3>());
    if (pose.doubled_area == 0) return;
    const double rest = 2 * element.area;
    const Vec3 normal = pose.edge[1].cross(pose.edge[2]) / pose.doubled_area;
    const double products = inverse_masses(element, x).dot(pose.squared) / (rest * rest);
    const double y = (pose.doubled_area / rest - 1) / (1 / (h * h * moduli_.kappa * element.area) + products);
    for (size_t k = 0; k < 3; ++k) {
        const int vertex = element.corner[k];
        x.col(vertex).head<3>() -= x(3, vertex) * y / rest * normal.cross(pose.edge[k]);
    }
}

void MembraneProjection::damp(const Triangle& triangle, const WeightedPoints& before, double h,
                              WeightedPoints& x) const {
    const MembraneElement& element = triangle.element;
    const MembranePose pose = membrane_pose(element, x.topRows<3>());
    Eigen::Vector3d rate;
    for (size_t k = 0; k < 3; ++k) {
        const int begin = element.corner[(k + 1) % 3], end = element.corner[(k + 2) % 3];
        const Vec3 was = (before.col(end) - before.col(begin)).head<3>();
        rate[static_cast<int>(k)] = 2 * pose.edge[k].dot(pose.edge[k] - was);
    }
    const Mat3 system =
        triangle.compliance / (h * element.relaxation) + edge_products(pose.edge, inverse_masses(element, x));
    pull_edges(element, pose, system.llt().solve(rate), x);
}

void MembraneProjection::sweep(WeightedPoints& x, const WeightedPoints& before, double h) const {
    for (const Triangle& triangle : triangles_) {
        if (kind_ == MembraneKind::stvk) {
            relax_edges(triangle, h, x);
        } else {
            relax_shape(triangle.element, h, x);
            relax_area(triangle.element, h, x);
        }
        if (triangle.element.relaxation > 0) damp(triangle, before, h, x);
    }
}

}  // namespace drape
