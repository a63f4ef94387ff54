#include "integrate/majorant_matrix.h"

#include "base/lanes.h"
#include "base/wide.h"

namespace drape {

namespace {

// L y = b, then L' x = y, in place and for the three coordinates side by side: Eigen would read L once for
// each. Columns of L begin with their diagonal.
DRAPE_WIDE void substitute(const int* first, const int* row, const double* value, int columns, double* x) {
    Lanes here, there;
    for (int j = 0; j < columns; ++j) {
        load(here, x + 4 * j);
        here /= value[first[j]];
        store(here, x + 4 * j);
        for (int k = first[j] + 1; k < first[j + 1]; ++k) {
            load(there, x + 4 * row[k]);
            there -= value[k] * here;
            store(there, x + 4 * row[k]);
        }
    }
    for (int j = columns - 1; j >= 0; --j) {
        load(here, x + 4 * j);
        for (int k = first[j] + 1; k < first[j + 1]; ++k) {
            load(there, x + 4 * row[k]);
            here -= value[k] * there;
        }
        here /= value[first[j]];
        store(here, x + 4 * j);
    }
}

// entries among free vertices; every place on the diagonal is there, be it zero
Eigen::SparseMatrix<double> matrix_of(const Majorant& majorant, const std::vector<int>& place, int free) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < free; ++i) entries.emplace_back(i, i, 0);
    for (const auto& entry : majorant.entries()) {
        const int i = place[static_cast<size_t>(entry.row())], j = place[static_cast<size_t>(entry.col())];
        if (i >= 0 && j >= 0) entries.emplace_back(i, j, entry.value());
    }
    Eigen::SparseMatrix<double> matrix(free, free);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

}  // namespace

MajorantMatrix::MajorantMatrix(const Dynamics& dynamics) {
    const Model& model = dynamics.model();
    std::vector<int> place(static_cast<size_t>(model.vertices()), -1);  // ascending: lower stays lower
    for (int v = 0; v < model.vertices(); ++v) {
        if (model.inverse_mass[v] == 0) continue;
        place[static_cast<size_t>(v)] = static_cast<int>(vertex_.size());
        vertex_.push_back(v);
    }
    const auto free = static_cast<int>(vertex_.size());
    mass_.resize(free);
    for (int i = 0; i < free; ++i) mass_[i] = model.mass[vertex_[static_cast<size_t>(i)]];
    Majorant stiffness, damping;
    for (const ActiveForce& active : dynamics.forces()) {
        active.force->add_stiffness_majorant(stiffness);
        active.force->add_damping_majorant(damping);
    }
    stiffness_ = matrix_of(stiffness, place, free);
    damping_ = matrix_of(damping, place, free);
    fill(1);
    factor_.analyzePattern(matrix_);
}

void MajorantMatrix::fill(double c) {
    matrix_ = stiffness_ + damping_ / c;
    matrix_.diagonal() += mass_ / (c * c);
    diagonal_ = matrix_.diagonal();
}

Eigen::VectorXd MajorantMatrix::of_free(const Eigen::VectorXd& values) const {
    Eigen::VectorXd free(mass_.size());
    for (Eigen::Index i = 0; i < free.size(); ++i) free[i] = values[vertex_[static_cast<size_t>(i)]];
    return free;
}

void MajorantMatrix::factorise(double c, const Eigen::VectorXd& contact) {
    const Eigen::VectorXd wanted = of_free(contact);
    if (c == c_ && wanted == contact_) return;
    fill(c);
    matrix_.diagonal() += wanted;
    factor_.factorize(matrix_);
    contact_ = wanted;
    c_ = c;
    ++factorisations_;
}

void MajorantMatrix::follow(double c, const Eigen::VectorXd& contact) {
    if (c == c_) {
        const Eigen::ArrayXd ratio = (diagonal_ + of_free(contact)).array() / (diagonal_ + contact_).array();
        if ((ratio < 2).all() && (ratio > 0.5).all()) return;
    }
    factorise(c, contact);
}

Points MajorantMatrix::solve(In right) const {
    const Matrix& lower = factor_.matrixL().nestedExpression();
    const auto& order = factor_.permutationP().indices();
    Eigen::Matrix4Xd ordered = Eigen::Matrix4Xd::Zero(4, mass_.size());  // x y z 0
    for (Eigen::Index i = 0; i < mass_.size(); ++i)
        ordered.col(order[i]).head<3>() = right.col(vertex_[static_cast<size_t>(i)]);
    substitute(lower.outerIndexPtr(), lower.innerIndexPtr(), lower.valuePtr(), static_cast<int>(lower.cols()),
               ordered.data());
    Points solution = Points::Zero(3, right.cols());
    for (Eigen::Index i = 0; i < mass_.size(); ++i)
        solution.col(vertex_[static_cast<size_t>(i)]) = ordered.col(order[i]).head<3>();
    return solution;
}

}  // namespace drape
