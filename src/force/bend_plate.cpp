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

// f -= K (x + tau v) for the rows of one cloth; returns v' K v. xv holds position and velocity by turns.
DRAPE_WIDE double multiply(const int* row, const int* column, const double* value, int rows, const double* xv,
                           double tau, double* f) {
    double quadratic = 0;
    for (int i = 0; i < rows; ++i) {
        Lanes kx = {}, kv = {};
        for (int k = row[i]; k < row[i + 1]; ++k) {
            Lanes p, q;
            load(p, xv + 8 * column[k]);
            load(q, xv + 8 * column[k] + 4);
            kx += value[k] * p;
            kv += value[k] * q;
        }
        Lanes v;
        load(v, xv + 8 * i + 4);
        const Lanes total = kx + tau * kv, heat = kv * v;
        f[3 * i] -= total[0];
        f[3 * i + 1] -= total[1];
        f[3 * i + 2] -= total[2];
        quadratic += heat[0] + heat[1] + heat[2];
    }
    return quadratic;
}

// f -= K x
DRAPE_WIDE void multiply(const int* row, const int* column, const double* value, int rows, const double* x,
                         double* f) {
    for (int i = 0; i < rows; ++i) {
        double sx = 0, sy = 0, sz = 0;
        for (int k = row[i]; k < row[i + 1]; ++k) {
            const double* p = x + 3 * column[k];
            sx += value[k] * p[0];
            sy += value[k] * p[1];
            sz += value[k] * p[2];
        }
        f[3 * i] -= sx;
        f[3 * i + 1] -= sy;
        f[3 * i + 2] -= sz;
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
        for (const auto& [j, value] : rows[i]) {
            column_.push_back(j);
            value_.push_back(value);
            sum += std::abs(value);
        }
        row_.push_back(static_cast<int>(column_.size()));
        fastest_squared = std::max(fastest_squared, sum / cloth.mass[static_cast<Eigen::Index>(i)]);
    }
    tau_ = bending_relaxation_time(cloth, fastest_squared);
    if (tau_ > 0) xv_ = Eigen::Matrix4Xd::Zero(4, 2 * cloth.vertices());
}

double BendPlate::energy(In x) const {
    double energy = 0;
    for (size_t i = 0; i + 1 < row_.size(); ++i) {
        Vec3 sum = Vec3::Zero();
        for (int k = row_[i]; k < row_[i + 1]; ++k)
            sum += value_[static_cast<size_t>(k)] * x.col(first_ + column_[static_cast<size_t>(k)]);
        energy += 0.5 * sum.dot(x.col(first_ + static_cast<Eigen::Index>(i)));
    }
    return energy;
}

void BendPlate::add_conservative(In x, Out f) const {
    multiply(row_.data(), column_.data(), value_.data(), static_cast<int>(row_.size()) - 1,
             x.data() + 3 * first_, f.data() + 3 * first_);
}

Power BendPlate::add_all(In x, In v, double, Out f) const {
    if (tau_ == 0) {
        add_conservative(x, f);
        return {};
    }
    const int rows = static_cast<int>(row_.size()) - 1;
    for (int i = 0; i < rows; ++i) {
        xv_.col(2 * i).head<3>() = x.col(first_ + i);
        xv_.col(2 * i + 1).head<3>() = v.col(first_ + i);
    }
    const double quadratic =
        multiply(row_.data(), column_.data(), value_.data(), rows, xv_.data(), tau_, f.data() + 3 * first_);
    return {tau_ * quadratic, 0};
}

void BendPlate::add_bound(In, StepBound& bound) const {
    for (size_t i = 0; i + 1 < row_.size(); ++i) {
        double sum = 0;
        for (int k = row_[i]; k < row_[i + 1]; ++k) sum += std::abs(value_[static_cast<size_t>(k)]);
        bound.stiffness[first_ + static_cast<Eigen::Index>(i)] += sum;
        bound.damping[first_ + static_cast<Eigen::Index>(i)] += tau_ * sum;
    }
}

void BendPlate::add_couplings(Couplings& couplings) const {
    for (size_t i = 0; i + 1 < row_.size(); ++i)
        for (int k = row_[i]; k < row_[i + 1]; ++k)
            couplings.couple(
                std::array{first_ + static_cast<int>(i), first_ + column_[static_cast<size_t>(k)]});
}

// visit(i, j, K_ij) for the lower triangle of K, which is the same for the three coordinates
template <class Visit>
void BendPlate::each_entry(Visit visit) const {
    for (size_t i = 0; i + 1 < row_.size(); ++i) {
        for (int k = row_[i]; k < row_[i + 1]; ++k) {
            const int row = static_cast<int>(i), column = column_[static_cast<size_t>(k)];
            if (column <= row) visit(first_ + row, first_ + column, value_[static_cast<size_t>(k)]);
        }
    }
}

void BendPlate::add_stiffness(In, BlockMatrix& k) const {
    each_entry([&](int i, int j, double value) { k.add_isotropic(i, j, value); });
}

void BendPlate::add_damping(In, In, double, BlockMatrix& b) const {
    if (tau_ > 0) each_entry([&](int i, int j, double value) { b.add_isotropic(i, j, tau_ * value); });
}

// K is constant and isotropic: its own majorant.
void BendPlate::add_stiffness_majorant(Majorant& k) const {
    each_entry([&](int i, int j, double value) { k.add_entry(i, j, value); });
}

void BendPlate::add_damping_majorant(Majorant& b) const {
    if (tau_ > 0) each_entry([&](int i, int j, double value) { b.add_entry(i, j, tau_ * value); });
}

}  // namespace drape
