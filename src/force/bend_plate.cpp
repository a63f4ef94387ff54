#include "force/bend_plate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/lanes.h"
#include "base/wide.h"
#include "force/plate_fit.h"

namespace drape {

namespace {

double rest_area(const Mesh& mesh, int f) {
    const Vec3 a = mesh.rest.col(mesh.faces(0, f));
    return (mesh.rest.col(mesh.faces(1, f)) - a).cross(mesh.rest.col(mesh.faces(2, f)) - a).norm() / 2;
}

// the upper triangle of K
struct Rows {
    const int* start;  // of each row, at its diagonal
    const int* column;
    const double* value;
    int count;
};

// f -= K (x + tau v) for one cloth; returns v' K v
DRAPE_WIDE double multiply(const Rows& k, const double* x, const double* v, double tau, double* f) {
    Lanes heat = {};
    for (int i = 0; i < k.count; ++i) {
        Lanes own_x, own_v, sum, kx = {}, kv = {};
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
            kx += value * p;
            kv += value * q;
            store(sum - value * ahead, f + at);
        }
        const Lanes diagonal = k.value[k.start[i]] * own_v;
        load(sum, f + 4 * i);
        store(sum - (k.value[k.start[i]] * own_x + kx + tau * (diagonal + kv)), f + 4 * i);
        heat += own_v * (diagonal + 2 * kv);
    }
    return lane_sum(heat);
}

// f -= K x
DRAPE_WIDE void multiply(const Rows& k, const double* x, double* f) {
    for (int i = 0; i < k.count; ++i) {
        Lanes own, sum, kx = {};
        load(own, x + 4 * i);
        for (int j = k.start[i] + 1; j < k.start[i + 1]; ++j) {
            const double value = k.value[j];
            const long at = 4 * static_cast<long>(k.column[j]);
            Lanes p;
            load(p, x + at);
            load(sum, f + at);
            kx += value * p;
            store(sum - value * own, f + at);
        }
        load(sum, f + 4 * i);
        store(sum - (k.value[k.start[i]] * own + kx), f + 4 * i);
    }
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
    const double nu = cloth.fabric.poisson;
    std::vector<std::map<int, double>> rows(static_cast<size_t>(cloth.vertices()));
    for (int t = 0; t < cloth.mesh.triangles(); ++t) {
        const CurvatureStencil stencil = curvature_stencil(cloth.mesh, cloth.topology, t);
        incomplete_ += !stencil.complete;
        const Eigen::VectorXd uu = stencil.weight.row(0), uv = stencil.weight.row(1),
                              vv = stencil.weight.row(2);
        const Eigen::MatrixXd k =
            cloth.fabric.bending * rest_area(cloth.mesh, t) *
            ((uu + vv) * (uu + vv).transpose() -
             (1 - nu) * (uu * vv.transpose() + vv * uu.transpose() - 2 * uv * uv.transpose()));
        for (size_t i = 0; i < stencil.vertex.size(); ++i)
            for (size_t j = 0; j < stencil.vertex.size(); ++j)
                rows[static_cast<size_t>(stencil.vertex[i])][stencil.vertex[j]] +=
                    k(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
    double fastest_squared = 0;
    row_.push_back(0);
    for (size_t i = 0; i < rows.size(); ++i) {
        double sum = 0;
        rows[i].try_emplace(static_cast<int>(i), 0.0);  // no row without its diagonal
        for (const auto& [j, value] : rows[i]) {
            sum += std::abs(value);
            if (j < static_cast<int>(i)) continue;
            column_.push_back(j);
            value_.push_back(value);
        }
        row_.push_back(static_cast<int>(column_.size()));
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

// A shift costs nothing, so rows of K sum to 0 and x' K x = -sum_(i<j) K_ij |x_i - x_j|^2: no large terms
// that cancel far from the origin.
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
