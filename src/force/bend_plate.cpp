#include "force/bend_plate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/lanes.h"
#include "base/wide.h"
#include "force/edge_slope.h"
#include "force/plate_element.h"

namespace drape {

namespace {

constexpr double round_off = 1e-13;

// the upper triangle of K
struct Rows {
    const int* start;  // of each row, at its diagonal
    const int* column;
    const double* value;
    int count;
};

// Rows of K sum to 0, so (K x)_i = sum_j K_ij (x_j - x_i): what moves as one feels nothing, to the last bit
// and far from the origin, and what i feels j feels the other way.

// f -= K (x + tau v) for one cloth; returns v' K v
DRAPE_WIDE double multiply(const Rows& k, const double* x, const double* v, double tau, double* f) {
    Lanes heat = {};
    for (int i = 0; i < k.count; ++i) {
        Lanes own_x, own_v, sum, pull = {}, kv = {};
        load(own_x, x + 4 * i);
        load(own_v, v + 4 * i);
        const Lanes ahead = own_x + tau * own_v;
        for (int j = k.start[i] + 1; j < k.start[i + 1]; ++j) {
            const double value = k.value[j];
            const long at = 4 * static_cast<long>(k.column[j]);
            Lanes p, q;
            load(p, x + at);
            load(q, v + at);
            load(sum, f + at);
            const Lanes apart = value * (p + tau * q - ahead);
            pull += apart;
            kv += value * q;
            store(sum + apart, f + at);
        }
        load(sum, f + 4 * i);
        store(sum - pull, f + 4 * i);
        heat += own_v * (k.value[k.start[i]] * own_v + 2 * kv);
    }
    return lane_sum(heat);
}

// f -= K x
DRAPE_WIDE void multiply(const Rows& k, const double* x, double* f) {
    for (int i = 0; i < k.count; ++i) {
        Lanes own, sum, pull = {};
        load(own, x + 4 * i);
        for (int j = k.start[i] + 1; j < k.start[i + 1]; ++j) {
            const long at = 4 * static_cast<long>(k.column[j]);
            Lanes p;
            load(p, x + at);
            load(sum, f + at);
            const Lanes apart = k.value[j] * (p - own);
            pull += apart;
            store(sum + apart, f + at);
        }
        load(sum, f + 4 * i);
        store(sum - pull, f + 4 * i);
    }
}

// The plate of one triangle, its slopes expressed by vertices.
void add_triangle(const Cloth& cloth, int t, const std::vector<EdgeSlope>& slopes,
                  std::vector<std::map<int, double>>& rows) {
    const Mesh& mesh = cloth.mesh;
    std::array<Vec3, 3> corner;
    std::array<bool, 3> free;
    std::map<int, Eigen::Matrix<double, 6, 1>> share;  // of each vertex in w_0, w_1, w_2, s_0, s_1, s_2
    const auto of_vertex = [&](int v) -> Eigen::Matrix<double, 6, 1>& {
        return share.try_emplace(v, Eigen::Matrix<double, 6, 1>::Zero()).first->second;
    };
    for (int c = 0; c < 3; ++c) {
        const int e = cloth.topology.face_edges(c, t);
        const Edge& edge = cloth.topology.edges[static_cast<size_t>(e)];
        corner[static_cast<size_t>(c)] = mesh.rest.col(mesh.faces(c, t));
        of_vertex(mesh.faces(c, t))[c] = 1;
        free[static_cast<size_t>(c)] = edge.face_count != 2;
        const EdgeSlope& slope = slopes[static_cast<size_t>(e)];
        const double outward = edge.face[0] == t ? 1 : -1;
        for (size_t i = 0; i < slope.vertex.size(); ++i)
            of_vertex(slope.vertex[i])[3 + c] = outward * slope.weight[static_cast<Eigen::Index>(i)];
    }
    const Matrix6 k = plate_stiffness(corner, cloth.fabric.bending, cloth.fabric.poisson, free);
    for (const auto& [i, of_i] : share)
        for (const auto& [j, of_j] : share) rows[static_cast<size_t>(i)][j] += of_i.dot(k * of_j);
}

}  // namespace

double bending_relaxation_time(const Cloth& cloth, double fastest_bend_squared) {
    const Fabric& fabric = cloth.fabric;
    if (fabric.damping == 0 || fabric.bending == 0 || fastest_bend_squared == 0) return 0;
    const double length = std::cbrt(fabric.bending / (fabric.density * fabric.weighed_in));
    const double omega = std::sqrt(fabric.bending / fabric.density) / (length * length);
    Eigen::VectorXd rows = Eigen::VectorXd::Zero(cloth.vertices());
    for (const Spring& spring : cloth.network.edges) {
        rows[spring.a] += 2 * spring.stiffness;
        rows[spring.b] += 2 * spring.stiffness;
    }
    const double omega_stretch = std::sqrt(rows.cwiseQuotient(cloth.mass).maxCoeff());
    return std::min(2 * fabric.damping / omega, 0.1 * omega_stretch / fastest_bend_squared);
}

void BendPlate::keep(const std::vector<std::map<int, double>>& rows) {
    const auto diagonal = [&](int i) { return rows[static_cast<size_t>(i)].at(i); };
    std::vector<double> sum(rows.size(), 0.0);
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        row_.push_back(static_cast<int>(column_.size()));
        column_.push_back(i);
        value_.push_back(0);
        for (const auto& [j, value] : rows[static_cast<size_t>(i)]) {
            if (j <= i || std::abs(value) <= round_off * std::min(diagonal(i), diagonal(j))) continue;
            column_.push_back(j);
            value_.push_back(value);
            sum[static_cast<size_t>(i)] -= value;
            sum[static_cast<size_t>(j)] -= value;
        }
    }
    row_.push_back(static_cast<int>(column_.size()));
    for (size_t i = 0; i < rows.size(); ++i) value_[static_cast<size_t>(row_[i])] = sum[i];
}

BendPlate::BendPlate(const Cloth& cloth) : first_(cloth.first) {
    const Mesh& mesh = cloth.mesh;
    std::vector<EdgeSlope> slopes;
    for (const Edge& edge : cloth.topology.edges) {
        const bool free = edge.face_count != 2;
        slopes.push_back(free ? EdgeSlope{} : edge_slope(mesh, cloth.topology, edge));
    }
    std::vector<std::map<int, double>> rows(static_cast<size_t>(cloth.vertices()));
    for (int v = 0; v < cloth.vertices(); ++v) rows[static_cast<size_t>(v)][v] = 0;
    for (int t = 0; t < mesh.triangles(); ++t) add_triangle(cloth, t, slopes, rows);
    keep(rows);
    double fastest_squared = 0;
    for (size_t i = 0; i < rows.size(); ++i) {
        double sum = 0;
        for (const auto& [j, value] : rows[i]) sum += std::abs(value);
        fastest_squared = std::max(fastest_squared, sum / cloth.mass[static_cast<Eigen::Index>(i)]);
    }
    tau_ = bending_relaxation_time(cloth, fastest_squared);
}

template <class Visit>
void BendPlate::each_entry(Visit visit) const {
    for (size_t i = 0; i + 1 < row_.size(); ++i)
        for (int k = row_[i]; k < row_[i + 1]; ++k)
            visit(first_ + static_cast<int>(i), first_ + column_[static_cast<size_t>(k)],
                  value_[static_cast<size_t>(k)]);
}

// x' K x = -sum_(i<j) K_ij |x_i - x_j|^2, by the same rule
double BendPlate::energy(In x) const {
    double energy = 0;
    each_entry(
        [&](int i, int j, double value) { energy -= 0.5 * value * (x.col(i) - x.col(j)).squaredNorm(); });
    return energy;
}

void BendPlate::add_padded_conservative(const PaddedPoints& x, PaddedPoints& f) const {
    multiply({row_.data(), column_.data(), value_.data(), static_cast<int>(row_.size()) - 1},
             x.col(first_).data(), f.col(first_).data());
}

Power BendPlate::add_padded(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const {
    const double quadratic =
        multiply({row_.data(), column_.data(), value_.data(), static_cast<int>(row_.size()) - 1},
                 x.col(first_).data(), v.col(first_).data(), tau_, f.col(first_).data());
    return {tau_ * quadratic, 0};
}

void BendPlate::add_bound(In, StepBound& bound) const {
    const auto add = [&](int vertex, double value) {
        bound.stiffness[vertex] += value;
        bound.damping[vertex] += tau_ * value;
    };
    each_entry([&](int i, int j, double value) {
        add(i, std::abs(value));
        if (i != j) add(j, std::abs(value));
    });
}

void BendPlate::add_couplings(Couplings& couplings) const {
    each_entry([&](int i, int j, double) { couplings.couple(std::array{i, j}); });
}

void BendPlate::add_stiffness(In, BlockMatrix& k) const {
    each_entry([&](int i, int j, double value) { k.add_isotropic(j, i, value); });
}

void BendPlate::add_damping(In, In, double, BlockMatrix& b) const {
    if (tau_ > 0) each_entry([&](int i, int j, double value) { b.add_isotropic(j, i, tau_ * value); });
}

// K is constant and isotropic: its own majorant.
void BendPlate::add_stiffness_majorant(Majorant& k) const {
    each_entry([&](int i, int j, double value) { k.add_entry(j, i, value); });
}

void BendPlate::add_damping_majorant(Majorant& b) const {
    if (tau_ > 0) each_entry([&](int i, int j, double value) { b.add_entry(j, i, tau_ * value); });
}

}  // namespace drape
