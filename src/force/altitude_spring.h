// Altitude springs: from a triangle's corner x3 to its foot xm on the line through x1 and x2. They resist a
// triangle collapsing onto its edge, which edge springs alone let happen.
//   a = (x3 - x1).(x2 - x1) / |x2 - x1|^2 (signed),  xm = (1 - a) x1 + a x2,  h = |x3 - xm|,  n = (x3 - xm) /
//   h E = 1/2 k h0 (h/h0 - 1)^2,   f3 = -k (h/h0 - 1) n,   fm = -f3,   f1 = (1 - a) fm,   f2 = a fm
// The foot is where the distance is least, so moving it along the edge changes h to second order only
// (envelope theorem): grad h = (-(1 - a), -a, 1) n, and the shares above are minus the gradient of E. The
// lecture notes share the elastic force the other way round, f1 = a fm and f2 = (1 - a) fm, which is no
// gradient and exerts a torque (1 - 2a)(x1 - x2) x f3; tests/force/test_altitude_spring.cpp shows the energy
// it makes from nothing. Damping acts along the altitude with the same weights: f3 = -b n n' (v3 - vm), vm =
// (1 - a) v1 + a v2. At h = 0 or |x2 - x1| = 0 there is no direction and no force.
#pragma once

#include <optional>

#include "force/force.h"

namespace drape {

struct Altitude {
    double foot;    // a: where the foot stands, 0 at x1, 1 at x2; outside the edge in obtuse triangles
    double height;  // h [m]
    Vec3 up;        // n, from the foot to x3
};

std::optional<Altitude> altitude_of(const Vec3& x1, const Vec3& x2, const Vec3& x3);

// How the force at the foot is shared between the edge's ends.
enum class FootSharing {
    lever,  // (1 - a), a: minus the gradient of the energy
    notes,  // a, (1 - a): as the lecture notes have it. For tests and figures; no scene reaches it.
};

// Three springs a triangle (`all`), or one: the most compressed (`shortest`), or the most compressed and only
// beyond a fraction c (`compressed`: E = 1/2 W min(0, h/h0 - (1 - c))^2). `shortest` chooses by h/h0 with one
// W for the triangle, so that the energy is continuous where the choice changes; the force is not.
class AltitudeSprings final : public Force {
public:
    explicit AltitudeSprings(const Cloth& cloth, FootSharing sharing = FootSharing::lever);

    double energy(In x) const override;
    void add_conservative(In x, Out f) const override;
    Power add_all(In x, In v, double time, Out f) const override;
    bool is_conservative() const override { return !damped_; }
    void add_bound(In x, StepBound& bound) const override;
    void add_couplings(Couplings& couplings) const override;
    void add_stiffness(In x, BlockMatrix& k) const override;
    void add_damping(In x, In v, double time, BlockMatrix& b) const override;
    void add_stiffness_majorant(Majorant& k) const override;
    void add_damping_majorant(Majorant& b) const override;
    bool projects() const override { return true; }
    void project(WeightedPoints& x, const WeightedPoints& before, double h) override;

    // altitudes at work whose foot stands outside its edge
    int feet_outside(In x) const;

private:
    struct Pull {
        int x1, x2, x3;  // columns of the State: the edge's ends and the corner
        Altitude altitude;
        double tension;    // dE/dh [N]
        double stiffness;  // d2E/dh2 [N/m]
        double damping;    // [N s/m]
        double energy;     // [J]
    };
    // calls visit(Pull) for every altitude that acts at the pose x
    template <class Visit>
    void each(In x, Visit visit) const;
    // the same for those of one triangle; `x` may change between calls
    template <class Visit>
    void each_of(Eigen::Index triangle, In x, Visit visit) const;
    Pull pull_of(In x, Eigen::Index triangle, int corner, double weight, double slack) const;
    Eigen::Vector3d compression_of(In x, Eigen::Index triangle) const;
    // calls add(i, j, c) for each edge's c |x_i - x_j|^2 / 2 in the majorant of altitudes of `coefficient`
    template <class Add>
    void bound_triangle(Eigen::Index triangle, const Eigen::Vector3d& coefficient, Add add) const;
    static Eigen::Vector3d row_sums(In x, const Pull& pull);  // of its stiffness, for x1, x2, x3 [N/m]

    Faces faces_;
    std::vector<TriangleAltitudes> rest_;
    Points damping_;  // 3 x F: per corner [N s/m]
    AltitudeMode mode_;
    double slack_ = 0;  // c of `compressed`
    FootSharing sharing_;
    bool damped_ = false;
    std::vector<int> order_;  // of triangles for project(), by colour; made on first use
};

}  // namespace drape
