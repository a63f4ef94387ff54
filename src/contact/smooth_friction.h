// Coulomb friction as a force, for implicit methods, which cannot take it as impulses after a step.
// A point pressed with N onto an obstacle and sliding with u along it feels
//   f = -mu N s(|u| / e) u / |u|,   s(y) = 2 y - y^2 for y < 1, else 1,   e = 1e-4 m/s
// minus the gradient by u of the convex potential mu N S(|u|), S = e (y^2 - y^3 / 3), e (y - 1/3) for y > 1.
// So the least of a step's potential is a step with friction, and below the friction angle cloth creeps with
// less than e: 0.2 mm in 2 s. The normal forces are held while a step is solved for; they and the potential
// have no common one.
#pragma once

#include <vector>

#include "contact/contact.h"

namespace drape {

class SmoothFriction {
public:
    static constexpr double creep = 1e-4;  // e [m/s]

    // Takes over the normal forces of the last add_all.
    void hold(const Contact& contact);
    bool holds_any() const { return !grips_.empty(); }

    double potential(In v) const;  // [W]
    // f += force; returns heat, and what moving obstacles put in [W]
    ContactWork add_force(In v, Out f) const;

    void add_damping(In v, BlockMatrix& b) const;  // B += -df/dv, semidefinite
    // A diagonal that bounds B / c: the parabola of this curvature through the present potential lies above
    // it at every velocity, as s(y) / y falls with y.
    void add_majorant(In v, double c, Eigen::VectorXd& diagonal) const;

private:
    Vec3 sliding(const Grip& grip, In v) const;

    std::vector<Grip> grips_;
};

}  // namespace drape
