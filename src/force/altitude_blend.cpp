#include "force/altitude_blend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "force/altitude_blend_kernel.h"
#include "force/blend_projection.h"

namespace drape {

using namespace blend;

namespace {

template <class Corner, class Edges, class Values>
Columns columns_of(const Corner& corner, const Edges& edges, const Values& area, const Values& weight,
                   const Values& damping) {
    return {{corner[0].data(), corner[1].data(), corner[2].data()},
            {edges[0].data(), edges[1].data(), edges[2].data()},
            area.data(),
            weight.data(),
            damping.data()};
}

}  // namespace

AltitudeBlend::~AltitudeBlend() = default;

AltitudeBlend::AltitudeBlend(const Cloth& cloth) : damped_(cloth.fabric.damping > 0) {
    const Mesh& mesh = cloth.mesh;
    for (int t = 0; t < mesh.triangles(); ++t) {
        double inverse_mass = 0;  // of s: sum |grad_i s|^2 / m_i at rest, |grad_i s| = |grad_i D| / D0 - ...
        const Eigen::Vector3d& height = cloth.network.altitudes[static_cast<size_t>(t)].rest_height;
        const Vec3 x[3] = {mesh.rest.col(mesh.faces(0, t)), mesh.rest.col(mesh.faces(1, t)),
                           mesh.rest.col(mesh.faces(2, t))};
        const double doubled_area = (x[1] - x[0]).cross(x[2] - x[0]).norm();
        const Vec3 normal = (x[1] - x[0]).cross(x[2] - x[0]) / doubled_area;
        for (int k = 0; k < 3; ++k) {
            const Vec3 edge = x[(k + 2) % 3] - x[(k + 1) % 3];
            const Vec3 to_next = x[(k + 1) % 3] - x[k], to_previous = x[(k + 2) % 3] - x[k];
            const Vec3 gradient =
                normal.cross(edge) / doubled_area +
                (to_next / to_next.squaredNorm() + to_previous / to_previous.squaredNorm()) / 3;
            inverse_mass += gradient.squaredNorm() / cloth.mass[mesh.faces(k, t)];
            corner_[k].push_back(cloth.first + mesh.faces(k, t));
            inverse_squared_edge_[k].push_back(height[k] * height[k] / (doubled_area * doubled_area));
        }
        const double weight = cloth.network.altitudes[static_cast<size_t>(t)].common_weight;
        inverse_double_area_.push_back(1 / doubled_area);
        weight_.push_back(weight);
        damping_.push_back(inverse_mass > 0 ? 2 * cloth.fabric.damping * std::sqrt(weight / inverse_mass)
                                            : 0);
    }
    sweep_ = BlendSweep(columns_of(corner_, inverse_squared_edge_, inverse_double_area_, weight_, damping_),
                        mesh.triangles());
}

double AltitudeBlend::energy(In x) const {
    const Columns t = columns_of(corner_, inverse_squared_edge_, inverse_double_area_, weight_, damping_);
    Corners p, g;
    double s[block], energy = 0;
    const int triangles = static_cast<int>(weight_.size());
    for (int from = 0; from < triangles; from += block) {
        const int count = std::min(block, triangles - from);
        p.fetch(t, x.data(), from, count);
        shape_gradient(t, p, from, count, g, s);
        for (int i = 0; i < count; ++i) energy += 0.5 * t.weight[from + i] * (s[i] - 1) * (s[i] - 1);
    }
    return energy;
}

void AltitudeBlend::add_padded_conservative(const PaddedPoints& x, PaddedPoints& f) const {
    sweep_.push(x, f);
}

Power AltitudeBlend::add_padded(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const {
    return {sweep_.push_damped(x, v, f), 0};
}

void AltitudeBlend::project(WeightedPoints& x, const WeightedPoints& before, double h) {
    if (!projection_)
        projection_ = std::make_unique<BlendProjection>(
            columns_of(corner_, inverse_squared_edge_, inverse_double_area_, weight_, damping_),
            static_cast<int>(weight_.size()));
    projection_->sweep(x, before, h);
}

// With m the 8-mean of the edges' stretch, s = (D / D0) / m, d = grad D / (D0 m), r = grad ln m and
// T = W (s - 1), the Hessian is W g g' + T hess s, and
//   hess s = hess D / (D0 m) - d r' - r d' + s r r' - s hess ln m
//   hess ln m = sum p_i (1/2 hess q_i / q_i + 3/2 grad q_i grad q_i' / q_i^2) - 8 r r',  p_i = q_i^4 / sum
//   q^4
// hess D has blocks (e_i . e_j) / D n n' and, off the diagonal, a quarter turn in the plane, of norm 1. Row k
// sums the norms of its blocks; parts that are negative for the sign of T buckle and do not vibrate.
void AltitudeBlend::add_bound(In x, StepBound& bound) const {
    const Columns t = columns_of(corner_, inverse_squared_edge_, inverse_double_area_, weight_, damping_);
    for (int i = 0; i < static_cast<int>(weight_.size()); ++i) {
        Corners p, g;
        double s = 0;
        p.fetch(t, x.data(), i, 1);
        shape_gradient(t, p, i, 1, g, &s);
        Vec3 edge[3];
        double curl[3], sum = 0;  // p_k / L_k^2
        for (int k = 0; k < 3; ++k) {
            edge[k] = x.col(t.corner[(k + 2) % 3][i]) - x.col(t.corner[(k + 1) % 3][i]);
            const double q = edge[k].squaredNorm() * t.inverse_squared_edge[k][i];
            curl[k] = std::pow(q, 3) * t.inverse_squared_edge[k][i];
            sum += std::pow(q, 4);
        }
        if (sum == 0) continue;  // a point
        const double doubled_area = edge[0].cross(edge[1]).norm();
        const double area_scale = t.inverse_double_area[i] / std::pow(sum / 3, 0.125);  // 1 / (D0 m)
        const double tension = t.weight[i] * (s - 1);
        double slope_g[3], slope_d[3], slope_r[3], sum_g = 0, sum_d = 0, sum_r = 0;
        for (double& c : curl) c /= sum;
        for (int k = 0; k < 3; ++k) {
            const int next = (k + 1) % 3, last = (k + 2) % 3;
            const Vec3 gradient(g.x[k][0], g.y[k][0], g.z[k][0]);
            const Vec3 r = curl[next] * edge[next] - curl[last] * edge[last];
            sum_g += slope_g[k] = gradient.norm();
            sum_d += slope_d[k] = (gradient + s * r).norm();
            sum_r += slope_r[k] = r.norm();
        }
        for (int k = 0; k < 3; ++k) {
            double row = slope_d[k] * sum_r + slope_r[k] * sum_d;
            if (tension > 0) {
                row += 9 * s * slope_r[k] * sum_r;
                for (int j = 0; j < 3; ++j)
                    row += area_scale *
                           std::max(j == k ? 0.0 : 1.0, std::abs(edge[k].dot(edge[j])) / doubled_area);
            } else {
                row += 2 * area_scale + 14 * s * (curl[(k + 1) % 3] + curl[(k + 2) % 3]);
            }
            const int vertex = t.corner[k][i];
            bound.stiffness[vertex] += t.weight[i] * slope_g[k] * sum_g + std::abs(tension) * row;
            bound.damping[vertex] += t.damping[i] * slope_g[k] * sum_g;
        }
    }
}

void AltitudeBlend::add_couplings(Couplings& couplings) const {
    for (size_t i = 0; i < weight_.size(); ++i)
        couplings.couple(std::array{corner_[0][i], corner_[1][i], corner_[2][i]});
}

namespace {

using Vec9 = Eigen::Matrix<double, 9, 1>;
using Mat9 = Eigen::Matrix<double, 9, 9>;

struct Shape {
    double s = 0;
    Vec9 gradient = Vec9::Zero();
    Mat9 hessian = Mat9::Zero();
};

// s and its derivatives by the formulas above add_bound. With n the unit normal, grad_k D = n x e_k, and as
// moving corner j turns the normal by n_j = (I - n n') e_j x . / D,
//   hess D_kj = (e_k . e_j) / D n n' + n x (d e_k / d x_j),   d e_k / d x_(k+2) = I = -d e_k / d x_(k+1)
std::optional<Shape> shape_of(const Vec3 (&edge)[3], const double (&inverse_squared)[3],
                              double inverse_double_area) {
    const Vec3 doubled = edge[0].cross(edge[1]);
    const double doubled_area = doubled.norm();
    if (doubled_area == 0) return std::nullopt;
    const Vec3 n = doubled / doubled_area;
    Mat3 quarter_turn;
    quarter_turn << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;

    double q[3], sum = 0;
    for (int k = 0; k < 3; ++k) {
        q[k] = edge[k].squaredNorm() * inverse_squared[k];
        sum += std::pow(q[k], 4);
    }
    const double scale = inverse_double_area / std::pow(sum / 3, 0.125);  // 1 / (D0 m)
    Shape shape;
    shape.s = doubled_area * scale;

    Vec9 d, r = Vec9::Zero();
    Mat9 area = Mat9::Zero(), edges = Mat9::Zero();  // hess D; the sum in hess ln m
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3, last = (k + 2) % 3;
        d.segment<3>(3 * k) = scale * n.cross(edge[k]);
        for (int j = 0; j < 3; ++j)
            area.block<3, 3>(3 * k, 3 * j) = edge[k].dot(edge[j]) / doubled_area * n * n.transpose();
        area.block<3, 3>(3 * k, 3 * next) -= quarter_turn;
        area.block<3, 3>(3 * k, 3 * last) += quarter_turn;
        // q_k and its derivatives live on the edge's two ends
        const double p = std::pow(q[k], 4) / sum;
        Vec9 along = Vec9::Zero();  // grad q / (2 q)
        along.segment<3>(3 * last) = edge[k] / edge[k].squaredNorm();
        along.segment<3>(3 * next) = -edge[k] / edge[k].squaredNorm();
        r += p * along;
        edges += 6 * p * along * along.transpose();
        const Mat3 own = p / edge[k].squaredNorm() * Mat3::Identity();
        edges.block<3, 3>(3 * next, 3 * next) += own;
        edges.block<3, 3>(3 * last, 3 * last) += own;
        edges.block<3, 3>(3 * next, 3 * last) -= own;
        edges.block<3, 3>(3 * last, 3 * next) -= own;
    }
    shape.gradient = d - shape.s * r;
    shape.hessian = scale * area - d * r.transpose() - r * d.transpose() + 9 * shape.s * r * r.transpose() -
                    shape.s * edges;
    return shape;
}

}  // namespace

template <class Visit>
void AltitudeBlend::each_shape(In x, Visit visit) const {
    for (size_t i = 0; i < weight_.size(); ++i) {
        Vec3 edge[3];
        double inverse_squared[3];
        std::array<int, 3> corner;
        for (size_t k = 0; k < 3; ++k) {
            corner[k] = corner_[k][i];
            edge[k] = x.col(corner_[(k + 2) % 3][i]) - x.col(corner_[(k + 1) % 3][i]);
            inverse_squared[k] = inverse_squared_edge_[k][i];
        }
        if (const auto shape = shape_of(edge, inverse_squared, inverse_double_area_[i]))
            visit(i, corner, *shape);
    }
}

void AltitudeBlend::add_stiffness(In x, BlockMatrix& k) const {
    each_shape(x, [&](size_t i, const std::array<int, 3>& corner, const Shape& shape) {
        k.add_element(corner, weight_[i] * (shape.gradient * shape.gradient.transpose() +
                                            (shape.s - 1) * shape.hessian));
    });
}

void AltitudeBlend::add_damping(In x, In, double, BlockMatrix& b) const {
    if (!damped_) return;
    each_shape(x, [&](size_t i, const std::array<int, 3>& corner, const Shape& shape) {
        b.add_element(corner, damping_[i] * shape.gradient * shape.gradient.transpose());
    });
}

// In the rest shape a move u changes s by sum_i b_i n_i . u_i, with u_i the change of edge i, n_i its
// direction and b_i = L_i cot(angle opposite) / D0 - 1 / (3 L_i), so that by Cauchy's inequality
//   (g . u)^2 <= sum_j |b_j| sum_i |b_i| |u_i|^2
// Twice that covers g g' and hess s of shapes near rest: where no edge is strained by more than a fifth.
template <class Add>
void AltitudeBlend::bound_triangle(size_t i, double coefficient, Add add) const {
    double squared[3], slope[3], sum = 0;
    for (int k = 0; k < 3; ++k) squared[k] = 1 / inverse_squared_edge_[k][i];
    for (int k = 0; k < 3; ++k) {
        const double length = std::sqrt(squared[k]);
        const double cotangent =
            (squared[(k + 1) % 3] + squared[(k + 2) % 3] - squared[k]) / 2 * inverse_double_area_[i];
        slope[k] = std::abs(length * cotangent * inverse_double_area_[i] - 1 / (3 * length));
        sum += slope[k];
    }
    for (int k = 0; k < 3; ++k)
        add(corner_[(k + 1) % 3][i], corner_[(k + 2) % 3][i], 2 * coefficient * slope[k] * sum);
}

void AltitudeBlend::add_stiffness_majorant(Majorant& k) const {
    for (size_t i = 0; i < weight_.size(); ++i)
        bound_triangle(i, weight_[i], [&](int a, int b, double c) { k.add_difference(a, b, c); });
}

void AltitudeBlend::add_damping_majorant(Majorant& b) const {
    if (!damped_) return;
    for (size_t i = 0; i < weight_.size(); ++i)
        bound_triangle(i, damping_[i], [&](int a, int c, double rate) { b.add_difference(a, c, rate); });
}

}  // namespace drape
