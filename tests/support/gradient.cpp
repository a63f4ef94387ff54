#include "support/gradient.h"

namespace drape::test {

Points minus_gradient(const std::function<double(In)>& energy, Points x, double h) {
    Points gradient(3, x.cols());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        double& value = x.data()[i];
        const double kept = value;
        const auto at = [&](double offset) {
            value = kept + offset;
            return energy(x);
        };
        gradient.data()[i] = -(8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
        value = kept;
    }
    return gradient;
}

Vec3 net_force(In f) {
    return f.rowwise().sum();
}

Vec3 net_torque(In x, In f) {
    Vec3 torque = Vec3::Zero();
    for (Eigen::Index i = 0; i < x.cols(); ++i) torque += Vec3(x.col(i)).cross(Vec3(f.col(i)));
    return torque;
}

}  // namespace drape::test
