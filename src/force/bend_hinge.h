// Hinge bending: per inner edge e with neighbours of rest areas A1, A2 and dihedral angle theta,
//   E = 1/2 c (theta - theta0)^2,   c = B |e|^2 / (A1 + A2)
// theta is 0 in a flat sheet and theta0 its rest angle, so cloth that is curved at rest keeps its curve. Its
// rigidity is right only on equilateral meshes (up to 3 times too stiff on one_way ones): kept for
// comparison; `plate` is the default. Damping f = -tau c (d theta/dt) grad theta. A triangle without area has
// no angle and no force.
#pragma once

#include "force/force.h"

namespace drape {

class BendHinge final : public Force {
public:
    explicit BendHinge(const Cloth& cloth);

    double energy(In x) const override;
    void add_conservative(In x, Out f) const override;
    Power add_all(In x, In v, double time, Out f) const override;
    bool is_conservative() const override { return tau_ == 0; }
    void add_bound(In x, StepBound& bound) const override;
    void add_couplings(Couplings& couplings) const override;
    void add_stiffness(In x, BlockMatrix& k) const override;
    void add_damping(In x, In v, double time, BlockMatrix& b) const override;
    void add_stiffness_majorant(Majorant& k) const override;
    void add_damping_majorant(Majorant& b) const override;

private:
    struct Hinge {
        int vertex[4];     // the edge's ends, then the corner of each triangle; columns of the State
        double stiffness;  // c [N m]
        double rest_angle;
        double foot[2], height[2];  // of the corners over the edge, at rest: part of the edge, [m]
    };
    void add_scaled_majorant(double factor, Majorant& majorant) const;

    std::vector<Hinge> hinges_;
    double tau_ = 0;  // [s]
};

}  // namespace drape
