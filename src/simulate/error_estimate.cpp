#include "simulate/error_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape {

ErrorNorms distance_between(In a, In b) {
    const Eigen::VectorXd squared = (a - b).colwise().squaredNorm();
    return {std::sqrt(squared.mean()), std::sqrt(squared.maxCoeff())};
}

double error_share(double own, double other, double order) {
    return 1 / std::abs(std::pow(own / other, order) - 1);
}

double stated_share(double distance, double share, double edge) {
    return share * distance <= edge ? share : std::min(share, std::max(2.0, edge / distance));
}

double mean_edge(const Model& model) {
    double sum = 0, count = 0;
    for (const Cloth& cloth : model.cloths) {
        for (const Spring& edge : cloth.network.edges) sum += edge.rest_length;
        count += static_cast<double>(cloth.network.edges.size());
    }
    return sum / count;
}

double observed_order(const std::array<double, 3>& steps, double first_distance, double second_distance,
                      double least, double most) {
    // the ratio grows with p: bisect
    const auto ratio = [&](double p) {
        return (std::pow(steps[1] / steps[0], p) - 1) / (1 - std::pow(steps[1] / steps[2], p));
    };
    const double shown = first_distance / second_distance;
    double low = least, high = most;
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (ratio(middle) < shown ? low : high) = middle;
    }
    return (low + high) / 2;
}

double round_off(In x, double steps) {
    // errors of single steps add up like a random walk, and positions carry the velocities' along
    return std::numeric_limits<double>::epsilon() * x.cwiseAbs().maxCoeff() * std::sqrt(1 + steps);
}

Eigen::VectorXf vertex_errors(In a, In b, double share) {
    return (share * (a - b).colwise().norm().transpose()).cast<float>();
}

}  // namespace drape
