// Contact of one cloth with one obstacle: barrier force, normal damping, Coulomb friction with stick.
//
// Each contact point (sampling.h) at signed distance phi feels the barrier (barrier.h) over the gap g = phi -
// offset. The offset is as deep as a flat triangle between neighbouring points can dip into the obstacle, so
// that when every point keeps g > 0 the whole cloth stays outside. Normal damping -b g' n with b = 2 zeta
// sqrt(rho psi'') takes the rebound; the sum never pulls. Friction is an impulse of at most mu N h against
// sliding, and as much as stops it where that is less: below the friction angle a point's speed is exactly
// that of the obstacle.
//
// Methods that kick take the damping as an impulse too, each point's own implicit step: with w = sum w_i^2 /
// m_i the point opens by g' / (1 + h A b w) afterwards. That never turns it round, whatever h, so that
// damping does not shorten the step; as a force at the barrier's own frequency it would by more than half
// (verlet.cpp).
#pragma once

#include <vector>

#include "cloth/block_matrix.h"
#include "contact/barrier.h"
#include "contact/grip.h"
#include "contact/impulse.h"
#include "contact/sampling.h"
#include "obstacle/obstacle.h"

namespace drape {

// What contact did to the energy since it was last asked [J].
struct ContactWork {
    double dissipated = 0;
    double driven = 0;
};

// What contact asks of the next step.
struct ContactLimits {
    double omega_squared = 0;  // largest row sum of stiffness over mass of a vertex in contact [1/s^2]
    double gamma = 0;          // the same of damping [1/s]
    double closing_rate = 0;   // largest closing speed over the way that one step may go [1/s]

    void include(const ContactLimits& other);  // of another obstacle or cloth
};

// How a method takes normal damping: in add_all's force, or as rub's impulses.
enum class NormalDamping { force, impulse };

class ObstacleContact {
public:
    // `expected_speed`: an impact that the barrier takes with ease [m/s]; faster ones shorten the step.
    ObstacleContact(const Model& model, const Cloth& cloth, const Obstacle& obstacle, const Vec3& gravity,
                    double expected_speed);

    // Gathers the points that motion may bring into contact within `way` [m] of travel.
    void gather(In x, double time, double way);

    double energy(In x, double time) const;
    void add_conservative(In x, double time, Out f) const;
    struct Result {
        double dissipated = 0, driven = 0;  // power [W]
        ContactLimits limits;
        double least_distance = INFINITY;  // of any point [m]
        int contacts = 0;
        bool crossed = false;  // a point has g <= 0: the step was too long
    };
    // Adds the barrier, and damping if that is a force; keeps the normal forces for rub.
    Result add_all(In x, In v, double time, Out f, NormalDamping damping = NormalDamping::force);

    // For implicit methods (obstacle_contact_matrices.cpp): which vertices contact couples, K += -df/dx and
    // B += -df/dv, symmetric.
    void add_couplings(Couplings& couplings) const;
    void add_stiffness(In x, In v, double time, BlockMatrix& k) const;
    void add_damping(In x, In v, double time, BlockMatrix& b) const;
    // A diagonal, the same for the three coordinates, that bounds K + B / c at this pose from above.
    void add_majorant(In x, In v, double time, double c, Eigen::VectorXd& diagonal) const;

    // Changes velocities by the impulses of a time h under the last add_all's normal forces: friction's, and
    // damping's if that is none of those.
    ContactWork rub(Points& v, const Model& model, double h) const;

    // Appends the points of the last add_all that friction holds.
    void list_grips(std::vector<Grip>& grips) const;

    // How much of `move` from x (at most 1) no listed point crosses on its way, each keeping a tenth of its
    // gap. 0 where one has crossed already.
    double clear_part(In x, In move, double time) const;

    // Whether a listed point and the obstacle, each on its way through a step, were in one place meanwhile,
    // though at neither end: so far may either go in a step.
    bool passed_through(In before, double from, In after, double to) const;

    // The least distance of any point of any triangle, on a lattice finer than the contact points' [m]. Those
    // `held` at a pin, which nothing may be able to keep outside, need not count.
    double least_distance(In x, double time, bool held = true) const;

    void lower_gap_shares(In x, double time, Eigen::VectorXd& shares) const;  // as Contact::gap_shares

    // Moves vertices that start nearer than they would rest, or in the obstacle by no more than `most`, out
    // to where the barrier carries the cloth's weight, so that it does not throw them. Returns the largest
    // move [m]; throws Error where the cloth starts deeper inside.
    double lift_out(Points& x, const Model& model, double most) const;
    // Throws Error where a contact point is in the obstacle, or as near as none may come.
    void demand_outside(In x) const;

    const Barrier& barrier() const { return barrier_; }
    double offset() const { return offset_; }
    int level() const { return level_; }
    const Obstacle& obstacle() const { return obstacle_; }

private:
    struct Touch {  // a point in contact: what friction needs to know
        const ContactPoint* point;
        Vec3 normal, surface_velocity;
        double normal_force;  // [N]
        double stiffness;     // [N/m]
        double damping;       // [N s/m]
    };
    // Gershgorin: each vertex's row sums over all its points in contact; taken and cleared by limit_modes
    void add_rows(const Touch& touch);
    void limit_modes(ContactLimits& limits);
    SurfaceSample sample(const Pose& pose, const Vec3& p) const;
    double damping_at(double stiffness) const;  // b per area, of the barrier's stiffness per area

    struct Press {  // a point that presses on the obstacle
        const ContactPoint* point;
        Vec3 at, normal;
        double gap, opening;  // [m], [m/s]
        double pressure;      // damping included [Pa]
    };
    template <class Visit>
    void each_press(In x, In v, const MovingPose& moving, Visit visit) const;

    Obstacle obstacle_;
    Faces faces_;  // columns of the State
    std::vector<ContactPoint> points_;
    std::vector<int> near_;  // points within reach since the last gather
    std::vector<Touch> touches_;
    NormalDamping damping_ = NormalDamping::force;  // of touches_
    Eigen::VectorXd inverse_mass_;                  // per column of the State [1/kg]
    Eigen::Matrix2Xd rows_;                         // of stiffness and damping; zero but within add_all
    Barrier barrier_;
    double offset_ = 0;  // [m]
    int level_ = 1;
    double area_density_ = 0;  // of the cloth [kg/m^2]
    double resting_gap_ = 0;   // where the barrier carries the weight [m]
    double spacing_ = 0;       // between contact points at most [m]
};

}  // namespace drape
