#include "contact/neighbours.h"

#include <algorithm>

namespace drape {

namespace {

constexpr int smoothings = 6, corrections = 8;

}  // namespace

Neighbours::Neighbours(const Model& model, In x) : model_(model), edges_at_(static_cast<size_t>(x.cols())) {
    for (const Cloth& cloth : model.cloths)
        for (const Edge& edge : cloth.topology.edges) {
            const auto [i, j] = edge.vertex;
            const int a = cloth.first + i, b = cloth.first + j;
            edges_at_[static_cast<size_t>(a)].push_back(edges_.size());
            edges_at_[static_cast<size_t>(b)].push_back(edges_.size());
            edges_.push_back({a, b});
            length_.push_back((x.col(a) - x.col(b)).norm());
            rest_length_.push_back((cloth.mesh.rest.col(i) - cloth.mesh.rest.col(j)).norm());
        }
}

void Neighbours::relax(int vertex) {
    for (const size_t e : edges_at_[static_cast<size_t>(vertex)])
        length_[e] = std::min(length_[e], rest_length_[e]);
}

void Neighbours::smooth(Points& move) const {
    for (int k = 0; k < smoothings; ++k) {
        Points around = Points::Zero(3, move.cols());
        for (const auto& [a, b] : edges_) {
            around.col(a) += move.col(b);
            around.col(b) += move.col(a);
        }
        for (Eigen::Index i = 0; i < move.cols(); ++i) {
            const size_t edges = edges_at_[static_cast<size_t>(i)].size();
            if (model_.inverse_mass[i] == 0)
                move.col(i).setZero();
            else if (edges > 0)
                move.col(i) = (move.col(i) + around.col(i) / static_cast<double>(edges)) / 2;
        }
    }
}

void Neighbours::keep_lengths(Points& x) const {
    for (int k = 0; k < corrections; ++k)
        for (size_t e = 0; e < edges_.size(); ++e) {
            const auto [a, b] = edges_[e];
            const double give_a = model_.inverse_mass[a] > 0 ? 1 : 0;
            const double give_b = model_.inverse_mass[b] > 0 ? 1 : 0;
            const Vec3 way = x.col(b) - x.col(a);
            const double now = way.norm();
            if (give_a + give_b == 0 || now == 0) continue;
            const Vec3 correction = way * ((now - length_[e]) / now / (give_a + give_b));
            x.col(a) += give_a * correction;
            x.col(b) -= give_b * correction;
        }
}

}  // namespace drape
