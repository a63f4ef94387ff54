#include "simulate/strain.h"

#include <algorithm>
#include <cmath>

namespace drape {

namespace {

template <class Visit>
void each_strain(const Cloth& cloth, In x, Visit visit) {
    for (const Spring& edge : cloth.network.edges)
        if (edge.rest_length > 0)
            visit(edge,
                  (x.col(cloth.first + edge.a) - x.col(cloth.first + edge.b)).norm() / edge.rest_length - 1);
}

}  // namespace

Eigen::VectorXf vertex_strain(const Cloth& cloth, In x) {
    Eigen::VectorXf strain = Eigen::VectorXf::Zero(cloth.vertices());
    each_strain(cloth, x, [&](const Spring& edge, double value) {
        for (const int end : {edge.a, edge.b})
            if (std::abs(value) > std::abs(strain[end])) strain[end] = static_cast<float>(value);
    });
    return strain;
}

double largest_strain(const Model& model, In x) {
    double largest = 0;
    for (const Cloth& cloth : model.cloths)
        each_strain(cloth, x,
                    [&](const Spring&, double value) { largest = std::max(largest, std::abs(value)); });
    return largest;
}

}  // namespace drape
