#include "cloth/block_matrix.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/OrderingMethods>
#include <algorithm>

#include "base/assert.h"

namespace drape {

namespace {

using Element = BlockMatrix::Element;

// A Cholesky factorisation costs a tenth of the eigenvectors, and most elements need no more.
void make_semidefinite(Element& k) {
    const double size = k.diagonal().cwiseAbs().maxCoeff();
    Element shifted = k;
    shifted.diagonal().array() += 1e-12 * size;
    if (size > 0 && Eigen::LLT<Element>(shifted).info() == Eigen::Success) return;
    const Eigen::SelfAdjointEigenSolver<Element> modes(k);
    k = modes.eigenvectors() * modes.eigenvalues().cwiseMax(0.0).asDiagonal() *
        modes.eigenvectors().transpose();
}

}  // namespace

void Couplings::couple(std::span<const int> vertices) {
    for (size_t i = 0; i < vertices.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            if (vertices[i] != vertices[j])
                pairs_.emplace_back(std::max(vertices[i], vertices[j]), std::min(vertices[i], vertices[j]));
}

BlockMatrix::BlockMatrix(const Model& model, const Couplings& couplings) : mass_(model.mass) {
    number_vertices(model, couplings);
    lay_out(couplings);
}

// Approximate minimum degree on the vertices; the three rows of each stay together.
void BlockMatrix::number_vertices(const Model& model, const Couplings& couplings) {
    std::vector<int> free, index(static_cast<size_t>(model.vertices()), -1);
    for (int v = 0; v < model.vertices(); ++v) {
        if (model.inverse_mass[v] == 0) continue;
        index[static_cast<size_t>(v)] = static_cast<int>(free.size());
        free.push_back(v);
    }
    const auto count = static_cast<int>(free.size());
    place_.assign(index.size(), -1);
    vertex_.resize(free.size());
    if (free.empty()) return;

    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < count; ++i) entries.emplace_back(i, i, 1);
    for (const auto& [a, b] : couplings.pairs()) {
        const int i = index[static_cast<size_t>(a)], j = index[static_cast<size_t>(b)];
        if (i >= 0 && j >= 0) entries.emplace_back(i, j, 1);
    }
    Eigen::SparseMatrix<double> graph(count, count);
    graph.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(graph, order);
    for (int i = 0; i < count; ++i) {
        const int vertex = free[static_cast<size_t>(order.indices()[i])];
        vertex_[static_cast<size_t>(i)] = vertex;
        place_[static_cast<size_t>(vertex)] = i;
    }
}

void BlockMatrix::lay_out(const Couplings& couplings) {
    const auto columns = static_cast<int>(vertex_.size());
    std::vector<std::pair<int, int>> blocks;  // column, row
    for (int i = 0; i < columns; ++i) blocks.emplace_back(i, i);
    for (const auto& [a, b] : couplings.pairs()) {
        const int i = place_[static_cast<size_t>(a)], j = place_[static_cast<size_t>(b)];
        if (i >= 0 && j >= 0) blocks.emplace_back(std::min(i, j), std::max(i, j));
    }
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());

    // a column of n blocks holds 3n, 3n - 1 and 3n - 2 entries from its diagonal down
    lower_.resize(3 * columns, 3 * columns);
    lower_.resizeNonZeros(9 * static_cast<Eigen::Index>(blocks.size()) - 3 * columns);
    size_t next = 0;
    int filled = 0;
    for (int column = 0; column < columns; ++column) {
        first_block_.push_back(static_cast<int>(next));
        while (next < blocks.size() && blocks[next].first == column)
            block_row_.push_back(blocks[next++].second);
        for (int j = 0; j < 3; ++j) {
            lower_.outerIndexPtr()[3 * column + j] = filled;
            for (auto k = static_cast<size_t>(first_block_.back()); k < next; ++k)
                for (int i = 3 * block_row_[k]; i < 3 * block_row_[k] + 3; ++i)
                    if (i >= 3 * column + j) lower_.innerIndexPtr()[filled++] = i;
        }
    }
    first_block_.push_back(static_cast<int>(next));
    lower_.outerIndexPtr()[3 * columns] = filled;
    set_zero();
}

void BlockMatrix::set_zero() {
    lower_.coeffs().setZero();
}

void BlockMatrix::weigh(double factor, bool semidefinite) {
    factor_ = factor;
    semidefinite_ = semidefinite;
}

void BlockMatrix::add_block(int row, int column, const Mat3& value) {
    const auto rows = block_row_.begin();
    const auto first = rows + first_block_[static_cast<size_t>(column)],
               last = rows + first_block_[static_cast<size_t>(column) + 1];
    const auto found = std::lower_bound(first, last, row);
    DRAPE_ASSERT(found != last && *found == row);
    const auto above = 3 * (found - first);
    for (int j = 0; j < 3; ++j) {
        // column j starts at the diagonal, j rows below its first block's top
        double* entry = lower_.valuePtr() + lower_.outerIndexPtr()[3 * column + j] + above - j;
        for (int i = row == column ? j : 0; i < 3; ++i) entry[i] += value(i, j);
    }
}

void BlockMatrix::add_element(std::span<const int> vertices, const Element& k) {
    DRAPE_ASSERT(vertices.size() <= most_vertices);
    DRAPE_ASSERT(k.rows() == static_cast<Eigen::Index>(3 * vertices.size()));
    Element projected;
    if (semidefinite_) make_semidefinite(projected = k);
    const Element& element = semidefinite_ ? projected : k;
    for (size_t i = 0; i < vertices.size(); ++i) {
        const int row = place_[static_cast<size_t>(vertices[i])];
        if (row < 0) continue;
        for (size_t j = 0; j <= i; ++j) {
            const int column = place_[static_cast<size_t>(vertices[j])];
            if (column < 0) continue;
            const Mat3 block = factor_ * element.block<3, 3>(static_cast<Eigen::Index>(3 * i),
                                                             static_cast<Eigen::Index>(3 * j));
            if (row >= column)
                add_block(row, column, block);
            else
                add_block(column, row, block.transpose());
        }
    }
}

void BlockMatrix::add_point(std::span<const int> vertices, std::span<const double> weights, const Mat3& k) {
    DRAPE_ASSERT(vertices.size() == weights.size());
    Element projected = k;
    if (semidefinite_) make_semidefinite(projected);
    const Mat3 symmetric = projected.selfadjointView<Eigen::Lower>();
    for (size_t i = 0; i < vertices.size(); ++i) {
        for (size_t j = 0; j <= i; ++j) {
            const int a = place_[static_cast<size_t>(vertices[i])],
                      b = place_[static_cast<size_t>(vertices[j])];
            if (a >= 0 && b >= 0)
                add_block(std::max(a, b), std::min(a, b), factor_ * weights[i] * weights[j] * symmetric);
        }
    }
}

void BlockMatrix::add_isotropic(int i, int j, double value) {
    const int a = place_[static_cast<size_t>(i)], b = place_[static_cast<size_t>(j)];
    if (a >= 0 && b >= 0) add_block(std::max(a, b), std::min(a, b), factor_ * value * Mat3::Identity());
}

void BlockMatrix::add_masses(double factor) {
    for (size_t i = 0; i < vertex_.size(); ++i) {
        const auto at = static_cast<int>(i);
        add_block(at, at, factor * mass_[vertex_[i]] * Mat3::Identity());
    }
}

Points BlockMatrix::multiply(In x) const {
    Eigen::VectorXd free;
    gather(x, free);
    const Eigen::VectorXd product = lower_.selfadjointView<Eigen::Lower>() * free;
    Points y(3, x.cols());
    scatter(product, y);
    return y;
}

void BlockMatrix::gather(In x, Eigen::VectorXd& free) const {
    free.resize(lower_.rows());
    for (size_t i = 0; i < vertex_.size(); ++i)
        free.segment<3>(static_cast<Eigen::Index>(3 * i)) = x.col(vertex_[i]);
}

void BlockMatrix::scatter(const Eigen::VectorXd& free, Points& x) const {
    x.setZero();
    for (size_t i = 0; i < vertex_.size(); ++i)
        x.col(vertex_[i]) = free.segment<3>(static_cast<Eigen::Index>(3 * i));
}

}  // namespace drape
