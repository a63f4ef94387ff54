#include "force/bend_plate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/lanes.h"
#include "base/wide.h"
#include "force/edge_slope.h"
#include "force/plate_element.h"

namespace drape {

namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;

constexpr double round_off = 1e-13;

// The entries of a square matrix while it is assembled, row by row in no order.
struct MatrixRows {
    std::vector<std::vector<std::pair<int, double>>> row;

    void add(int i, int j, double value) {
        auto& entries = row[static_cast<size_t>(i)];
        for (auto& [column, sum] : entries) {
            if (column != j) continue;
            sum += value;
            return;
        }
        entries.emplace_back(j, value);
    }
};

struct Rows {
    const int* start;
    const int* column;
    const double* value;
    int count;
};

Rows rows_of(const UpperRows& k) {
    return {k.start.data(), k.column.data(), k.value.data(), static_cast<int>(k.start.size()) - 1};
}

// Rows of K sum to 0, so (K x)_i = sum_j K_ij (x_j - x_i): what moves as one feels nothing, to the last bit
// and far from the origin, and what i feels j feels the other way.

// f -= K (x + tau v) for one cloth; returns v' K v
DRAPE_WIDE double multiply(const Rows& rows, const double* x, const double* v, double tau, double* f) {
    const Rows k = rows;  // stores do not change it, which the compiler would doubt of what lies elsewhere
    Lanes heat = {};
    for (int i = 0; i < k.count; ++i) {
        Lanes own_x, own_v, sum, pull = {}, kv = {};
        load(own_x, x + 4 * i);
        load(own_v, v + 4 * i);
        const Lanes ahead = own_x + tau * own_v;
        const int end = k.start[i + 1];
        for (int j = k.start[i] + 1; j < end; ++j) {
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
DRAPE_WIDE void multiply(const Rows& rows, const double* x, double* f) {
    const Rows k = rows;
    for (int i = 0; i < k.count; ++i) {
        Lanes own, sum, pull = {};
        load(own, x + 4 * i);
        const int end = k.start[i + 1];
        for (int j = k.start[i] + 1; j < end; ++j) {
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
void add_triangle(const Cloth& cloth, int t, const std::vector<EdgeSlope>& slopes, MatrixRows& rows) {
    const Mesh& mesh = cloth.mesh;
    std::array<Vec3, 3> corner;
    std::array<bool, 3> free;
    std::vector<int> vertices;
    std::vector<Vec6> shares;  // of each vertex in w_0, w_1, w_2, s_0, s_1, s_2
    const auto share_of = [&](int v) -> Vec6& {
        const auto at = std::find(vertices.begin(), vertices.end(), v) - vertices.begin();
        if (at == static_cast<std::ptrdiff_t>(vertices.size())) {
            vertices.push_back(v);
            shares.emplace_back(Vec6::Zero());
        }
        return shares[static_cast<size_t>(at)];
    };
    for (int c = 0; c < 3; ++c) {
        const auto e = static_cast<size_t>(cloth.topology.face_edges(c, t));
        const Edge& edge = cloth.topology.edges[e];
        corner[static_cast<size_t>(c)] = mesh.rest.col(mesh.faces(c, t));
        share_of(mesh.faces(c, t))[c] = 1;
        free[static_cast<size_t>(c)] = edge.face_count != 2;
        const EdgeSlope& slope = slopes[e];
        const double outward = edge.face[0] == t ? 1 : -1;
        for (size_t i = 0; i < slope.vertex.size(); ++i)
            share_of(slope.vertex[i])[3 + c] = outward * slope.weight[static_cast<Eigen::Index>(i)];
    }
    const Matrix6 k = plate_stiffness(corner, cloth.fabric.bending, cloth.fabric.poisson, free);
    for (size_t i = 0; i < vertices.size(); ++i) {
        const Vec6 force = k * shares[i];
        for (size_t j = 0; j < vertices.size(); ++j) rows.add(vertices[i], vertices[j], force.dot(shares[j]));
    }
}

// What is round-off is left out; the diagonal makes rows sum to 0.
UpperRows upper_rows(const MatrixRows& rows) {
    UpperRows upper;
    const auto count = static_cast<int>(rows.row.size());
    std::vector<double> diagonal(rows.row.size(), 0.0), sum(rows.row.size(), 0.0);
    for (int i = 0; i < count; ++i)
        for (const auto& [j, value] : rows.row[static_cast<size_t>(i)])
            if (j == i) diagonal[static_cast<size_t>(i)] = value;
    for (int i = 0; i < count; ++i) {
        upper.start.push_back(static_cast<int>(upper.column.size()));
        upper.column.push_back(i);
        upper.value.push_back(0);
        auto entries = rows.row[static_cast<size_t>(i)];
        std::sort(entries.begin(), entries.end());
        for (const auto& [j, value] : entries) {
            const double least =
                round_off * std::min(diagonal[static_cast<size_t>(i)], diagonal[static_cast<size_t>(j)]);
            if (j <= i || std::abs(value) <= least) continue;
            upper.column.push_back(j);
            upper.value.push_back(value);
            sum[static_cast<size_t>(i)] -= value;
            sum[static_cast<size_t>(j)] -= value;
        }
    }
    upper.start.push_back(static_cast<int>(upper.column.size()));
    for (size_t i = 0; i < rows.row.size(); ++i) upper.value[static_cast<size_t>(upper.start[i])] = sum[i];
    return upper;
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

BendPlate::BendPlate(const Cloth& cloth) : first_(cloth.first) {
    const Mesh& mesh = cloth.mesh;
    std::vector<EdgeSlope> slopes;
    slopes.reserve(cloth.topology.edges.size());
    for (const Edge& edge : cloth.topology.edges) {
        const bool free = edge.face_count != 2;
        slopes.push_back(free ? EdgeSlope{} : edge_slope(mesh, cloth.topology, edge));
    }
    MatrixRows rows{std::vector<std::vector<std::pair<int, double>>>(static_cast<size_t>(cloth.vertices()))};
    for (int t = 0; t < mesh.triangles(); ++t) add_triangle(cloth, t, slopes, rows);
    k_ = upper_rows(rows);
    double fastest_squared = 0;
    for (size_t i = 0; i < rows.row.size(); ++i) {
        double sum = 0;
        for (const auto& [j, value] : rows.row[i]) sum += std::abs(value);
        fastest_squared = std::max(fastest_squared, sum / cloth.mass[static_cast<Eigen::Index>(i)]);
    }
    tau_ = bending_relaxation_time(cloth, fastest_squared);
}

template <class Visit>
void BendPlate::each_entry(Visit visit) const {
    for (size_t i = 0; i + 1 < k_.start.size(); ++i)
        for (int k = k_.start[i]; k < k_.start[i + 1]; ++k)
            visit(first_ + static_cast<int>(i), first_ + k_.column[static_cast<size_t>(k)],
                  k_.value[static_cast<size_t>(k)]);
}

// x' K x = -sum_(i<j) K_ij |x_i - x_j|^2, by the same rule
double BendPlate::energy(In x) const {
    double energy = 0;
    each_entry(
        [&](int i, int j, double value) { energy -= 0.5 * value * (x.col(i) - x.col(j)).squaredNorm(); });
    return energy;
}

void BendPlate::add_padded_conservative(const PaddedPoints& x, PaddedPoints& f) const {
    multiply(rows_of(k_), x.col(first_).data(), f.col(first_).data());
}

Power BendPlate::add_padded(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const {
    const double quadratic =
        multiply(rows_of(k_), x.col(first_).data(), v.col(first_).data(), tau_, f.col(first_).data());
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
