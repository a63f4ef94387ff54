// What contact's force changes by, for implicit methods. With p the pressure psi' and damping make, A the
// point's area, w its weights, n the normal, g the gap and g' = n . (v - surface velocity),
//   f = A p w (x) n,   p = -psi'(g) - b(g) g',   b = 2 zeta sqrt(rho psi''),   b' = b psi''' / (2 psi'')
//   -df/dx = A w w' (x) ( (psi'' + b' g') n n' - p hess g ),   -df/dv = A b w w' (x) n n'
// Where damping has eaten the pressure up there is no force and neither matrix. What turning the normal does
// to g' is left out: it is not symmetric, and small beside the rest. Friction is not in here.
#include <algorithm>

#include "contact/obstacle_contact.h"

namespace drape {

template <class Visit>
void ObstacleContact::each_press(In x, In v, const MovingPose& moving, Visit visit) const {
    for (const int i : near_) {
        const ContactPoint& point = points_[static_cast<size_t>(i)];
        const Vec3 at = value_at(point, x.data());
        const SurfaceSample s = sample(moving.pose, at);
        const double gap = s.distance - offset_;
        if (gap <= 0 || gap >= barrier_.thickness) continue;
        const Vec3 surface_velocity = obstacle_.motion.moves() ? moving.velocity_at(at) : Vec3::Zero();
        const double opening = s.normal.dot(value_at(point, v.data()) - surface_velocity);
        const double pressure = barrier_.pressure(gap) - damping_at(barrier_.stiffness(gap)) * opening;
        if (pressure > 0) visit(Press{&point, at, s.normal, gap, opening, pressure});
    }
}

void ObstacleContact::add_couplings(Couplings& couplings) const {
    for (Eigen::Index f = 0; f < faces_.cols(); ++f)
        couplings.couple(std::array{faces_(0, f), faces_(1, f), faces_(2, f)});
}

void ObstacleContact::add_stiffness(In x, In v, double time, BlockMatrix& k) const {
    const MovingPose moving = obstacle_.motion.at(time);
    const Mat3 turn = moving.pose.rotation;
    each_press(x, v, moving, [&](const Press& press) {
        const ContactPoint& point = *press.point;
        const double stiffness = barrier_.stiffness(press.gap);
        const double slope = damping_at(stiffness) * barrier_.stiffness_slope(press.gap) / (2 * stiffness);
        const Mat3 bend = turn * curvature(*obstacle_.solid, moving.pose.back(press.at)) * turn.transpose();
        k.add_point(
            {point.vertex, static_cast<size_t>(point.corners)},
            {point.weight, static_cast<size_t>(point.corners)},
            point.area * ((stiffness + slope * press.opening) * press.normal * press.normal.transpose() -
                          press.pressure * bend));
    });
}

void ObstacleContact::add_damping(In x, In v, double time, BlockMatrix& b) const {
    each_press(x, v, obstacle_.motion.at(time), [&](const Press& press) {
        const ContactPoint& point = *press.point;
        const double damping = damping_at(barrier_.stiffness(press.gap));
        b.add_point({point.vertex, static_cast<size_t>(point.corners)},
                    {point.weight, static_cast<size_t>(point.corners)},
                    point.area * damping * press.normal * press.normal.transpose());
    });
}

// w w' is at most diag(w), by Jensen's inequality. The bend of the surface only lowers K, but where a solid
// is hollow: inside a torus's ring, or against its rounding.
void ObstacleContact::add_majorant(In x, In v, double time, double c, Eigen::VectorXd& diagonal) const {
    each_press(x, v, obstacle_.motion.at(time), [&](const Press& press) {
        const double stiffness = barrier_.stiffness(press.gap), damping = damping_at(stiffness);
        const double slope = damping * barrier_.stiffness_slope(press.gap) / (2 * stiffness);
        const double bound =
            press.point->area * (std::max(stiffness + slope * press.opening, 0.0) + damping / c);
        for (int k = 0; k < press.point->corners; ++k)
            diagonal[press.point->vertex[k]] += press.point->weight[k] * bound;
    });
}

}  // namespace drape
