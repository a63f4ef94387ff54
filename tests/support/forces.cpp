#include "support/forces.h"

#include "support/matrices.h"

namespace drape::test {

std::unique_ptr<Force> make_force(std::string_view name, const Cloth& cloth, const Surroundings& world) {
    for (const ForceKind& kind : force_kinds())
        if (kind.name == name) return kind.make(cloth, world).force;
    return nullptr;
}

Points force_at(const Force& force, In x) {
    Points f = Points::Zero(3, x.cols());
    force.add_conservative(x, f);
    return f;
}

Points force_at(const Force& force, In x, In v, double time) {
    Points f = Points::Zero(3, x.cols());
    force.add_all(x, v, time, f);
    return f;
}

double largest_stiffness(const Force& force, const Points& x) {
    Eigen::MatrixXd stiffness(x.size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        Points ahead = x, behind = x;
        ahead.data()[i] += 1e-6;
        behind.data()[i] -= 1e-6;
        const Points change = (force_at(force, behind) - force_at(force, ahead)) / 2e-6;
        stiffness.col(i) = change.reshaped();
    }
    return eigenvalues(stiffness).maxCoeff();
}

double largest_bound(const Force& force, In x) {
    StepBound bound(static_cast<int>(x.cols()));
    force.add_bound(x, bound);
    return bound.stiffness.maxCoeff();
}

}  // namespace drape::test
