// A force is a function of the state and adds: it never clears, never sees the step, never moves a vertex.
// A new force is one file with its class, its row in force_kinds() (forces.cpp), its line in the README; the
// tests loop over the table and hold every force to the gradient of its energy.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "cloth/block_matrix.h"
#include "cloth/majorant.h"
#include "cloth/model.h"
#include "force/wind.h"

namespace drape {

// What a force does to the energy budget besides exchanging it with its own potential [W].
struct Power {
    double dissipated = 0;  // turned to heat; >= 0
    double driven = 0;      // put in from outside (wind); may be negative
    // Not power: at what rate velocities are damped beyond what add_bound allows for, at most [1/s]. So steps
    // can be shortened where a force that grows with speed finds more of that than was foreseen.
    double beyond_bound = 0;

    Power& operator+=(const Power& other) {
        dissipated += other.dissipated;
        driven += other.driven;
        beyond_bound += other.beyond_bound;
        return *this;
    }
};

// Row sums of stiffness and damping matrices, per vertex. By Gershgorin's theorem no mode of the
// mass-weighted matrix exceeds max_i rows_i / m_i.
struct StepBound {
    Eigen::VectorXd stiffness;  // sum_j |K_ij| [N/m]
    Eigen::VectorXd damping;    // sum_j |B_ij| [N s/m]

    explicit StepBound(int vertices)
        : stiffness(Eigen::VectorXd::Zero(vertices)), damping(Eigen::VectorXd::Zero(vertices)) {}
};

// Vertices as position-based methods move them: x, y, z and the inverse mass, 0 where pinned, in one column,
// so that a vertex is one load of four.
using WeightedPoints = Eigen::Matrix4Xd;

class PaddedForce;

class Force {
public:
    virtual ~Force() = default;

    // potential energy [J]; 0 for a force that has none (its file says why)
    virtual double energy(In x) const = 0;

    // f -= dE/dx [N]
    virtual void add_conservative(In x, Out f) const = 0;

    // f += everything, damping and driving included [N]; needs add_conservative's part too
    virtual Power add_all(In x, In v, double time, Out f) const {
        static_cast<void>(v);
        static_cast<void>(time);
        add_conservative(x, f);
        return {};
    }
    // this, where its sweeps work on padded vertices (padded_force.h)
    virtual const PaddedForce* padded() const { return nullptr; }
    virtual bool is_conservative() const { return true; }  // false: add_all does more than add_conservative
    // Whether what add_all does more is -B (v - something), B symmetric and constant at a pose.
    virtual bool is_linear_in_velocity() const { return true; }

    // adds this force's rows at the pose x; holds for small changes of pose
    virtual void add_bound(In x, StepBound& bound) const = 0;

    // For position-based methods.
    // Whether project() stands in for the force; else they take it explicitly.
    virtual bool projects() const { return false; }
    // One sweep: every element in turn moves its vertices by the implicit step of h that it would make alone,
    // from where `x` has them by now. `before` is where the step began. Not const: orders its elements on
    // first use.
    virtual void project(WeightedPoints& x, const WeightedPoints& before, double h) {
        static_cast<void>(x);
        static_cast<void>(before);
        static_cast<void>(h);
    }

    // For implicit methods. The defaults are those of a constant force.
    // Which vertices the two matrices couple, at any pose.
    virtual void add_couplings(Couplings& couplings) const { static_cast<void>(couplings); }
    // K += d2E/dx2 [N/m]
    virtual void add_stiffness(In x, BlockMatrix& k) const {
        static_cast<void>(x);
        static_cast<void>(k);
    }
    // B += -df/dv [N s/m]; where that is not symmetric and semidefinite, something near it that is
    virtual void add_damping(In x, In v, double time, BlockMatrix& b) const {
        static_cast<void>(x);
        static_cast<void>(v);
        static_cast<void>(time);
        static_cast<void>(b);
    }

    // For implicit methods with one constant matrix: bounds on what add_stiffness and add_damping add. Each
    // force says how far from rest its own holds.
    virtual void add_stiffness_majorant(Majorant& k) const { static_cast<void>(k); }
    virtual void add_damping_majorant(Majorant& b) const { static_cast<void>(b); }
};

// The world around the cloth.
struct Surroundings {
    Vec3 gravity{0, -9.81, 0};  // [m/s^2]
    AirDescription air;
};

// Either a force, or the reason why the scene does not need one. `because` is said either way.
struct MadeForce {
    std::unique_ptr<Force> force;
    std::string because;
};

struct ForceKind {
    std::string_view name;  // the stage's name in the plan
    MadeForce (*make)(const Cloth&, const Surroundings&);
};

// In the order in which they are added.
std::span<const ForceKind> force_kinds();

}  // namespace drape
