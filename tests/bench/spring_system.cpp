#include "bench/spring_system.h"

#include <algorithm>
#include <cmath>

namespace drape::bench {

SpringSystem spring_system(const Setup& setup) {
    const Cloth& cloth = setup.model.cloths.at(0);
    SpringSystem system;
    for (const Spring& spring : cloth.network.edges)
        system.springs.push_back({spring.a, spring.b, spring.rest_length, spring.stiffness});
    const auto values = setup.start.x.size();
    system.x.assign(setup.start.x.data(), setup.start.x.data() + values);
    system.v.assign(setup.start.v.data(), setup.start.v.data() + values);
    const Eigen::VectorXd& inverse_mass = setup.model.inverse_mass;
    system.inverse_mass.assign(inverse_mass.data(), inverse_mass.data() + inverse_mass.size());
    for (int c = 0; c < 3; ++c) system.gravity[c] = setup.world.gravity[c];
    return system;
}

void accelerate(const SpringSystem& system, const double* x, double* a) {
    std::fill(a, a + 3 * system.vertices(), 0.0);
    for (const PlainSpring& spring : system.springs) {
        const double* p = x + 3 * spring.a;
        const double* q = x + 3 * spring.b;
        const double dx = p[0] - q[0], dy = p[1] - q[1], dz = p[2] - q[2];
        const double length = std::sqrt(dx * dx + dy * dy + dz * dz);
        const double pull = spring.stiffness * (length - spring.rest_length) / length;
        double* fa = a + 3 * spring.a;
        double* fb = a + 3 * spring.b;
        fa[0] -= pull * dx;
        fa[1] -= pull * dy;
        fa[2] -= pull * dz;
        fb[0] += pull * dx;
        fb[1] += pull * dy;
        fb[2] += pull * dz;
    }
    for (int i = 0; i < system.vertices(); ++i) {
        const double inverse_mass = system.inverse_mass[static_cast<size_t>(i)];
        const double falls = inverse_mass > 0 ? 1 : 0;
        for (int c = 0; c < 3; ++c) a[3 * i + c] = a[3 * i + c] * inverse_mass + falls * system.gravity[c];
    }
}

Points as_points(const std::vector<double>& x) {
    return Eigen::Map<const Points>(x.data(), 3, static_cast<Eigen::Index>(x.size() / 3));
}

}  // namespace drape::bench
