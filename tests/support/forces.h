// One force by its name, and what it does at a pose.
#pragma once

#include <Eigen/Eigenvalues>
#include <memory>
#include <string_view>

#include "force/force.h"

namespace drape::test {

// null: the cloth or its surroundings have no use for it
inline std::unique_ptr<Force> make_force(std::string_view name, const Cloth& cloth,
                                         const Surroundings& world = {}) {
    for (const ForceKind& kind : force_kinds())
        if (kind.name == name) return kind.make(cloth, world).force;
    return nullptr;
}

inline Points force_at(const Force& force, In x) {
    Points f = Points::Zero(3, x.cols());
    force.add_conservative(x, f);
    return f;
}

inline Points force_at(const Force& force, In x, In v, double time = 0) {
    Points f = Points::Zero(3, x.cols());
    force.add_all(x, v, time, f);
    return f;
}

// The largest eigenvalue of the stiffness -df/dx at x, by central differences [N/m].
inline double largest_stiffness(const Force& force, const Points& x) {
    Eigen::MatrixXd stiffness(x.size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        Points ahead = x, behind = x;
        ahead.data()[i] += 1e-6;
        behind.data()[i] -= 1e-6;
        const Points change = (force_at(force, behind) - force_at(force, ahead)) / 2e-6;
        stiffness.col(i) = change.reshaped();
    }
    const Eigen::MatrixXd symmetric = (stiffness + stiffness.transpose()) / 2;
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .maxCoeff();
}

inline double largest_bound(const Force& force, In x) {
    StepBound bound(static_cast<int>(x.cols()));
    force.add_bound(x, bound);
    return bound.stiffness.maxCoeff();
}

}  // namespace drape::test
