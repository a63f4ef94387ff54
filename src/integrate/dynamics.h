// The equation of motion, m a = f(x, v, t), with pins and contact: what an integrator steps.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cloth/model.h"
#include "contact/contact.h"
#include "contact/smooth_friction.h"
#include "force/padded_force.h"

namespace drape {

// A force at work under its stage's name, and how often it was asked.
struct ActiveForce {
    std::string stage;
    std::unique_ptr<Force> force;
    mutable long calls = 0;
};

// Energy that left or entered since the start [J].
struct EnergyFlow {
    double dissipated = 0;  // damping, drag, friction: heat
    double driven = 0;      // wind, moving pins and obstacles
};

// Which forces: all, or only those that a method which projects (Force::project) takes explicitly.
enum class ForceShare { all, unprojected };

class Dynamics {
public:
    // `contact` may be null: no obstacle. The model must outlive this.
    Dynamics(const Model& model, std::vector<ActiveForce> forces, std::unique_ptr<Contact> contact);

    // a = conservative forces / m, gravity and contact's barrier included; 0 where pinned
    void conservative_acceleration(In x, double time, Points& a);

    // the same without contact: what bound() bounds
    void acceleration_without_contact(In x, Points& a, ForceShare share = ForceShare::all);

    // the forces alone whose damping is linear (Force::is_linear_in_velocity); 0 where pinned
    void linearly_damped_acceleration(In x, In v, Points& a, ForceShare share = ForceShare::all);

    // a = all forces / m; keeps power, contact limits and friction's normal forces of this moment
    void acceleration(In x, In v, double time, Points& a);

    // The same without contact's normal damping, for methods that kick: rub takes it with friction.
    void acceleration_to_kick(In x, In v, double time, Points& a, ForceShare share = ForceShare::all);

    // one sweep over all elements of the forces that project
    void project(WeightedPoints& x, const WeightedPoints& before, double h);

    // For implicit methods: the same with friction as a force (contact/smooth_friction.h), under the normal
    // forces that hold_friction last took over from an acceleration.
    void acceleration_with_friction(In x, In v, double time, Points& a);
    void hold_friction();
    const SmoothFriction& friction() const { return friction_; }

    // friction's impulses of a time h on free vertices' velocities, and after acceleration_to_kick damping's
    void rub(State& state, double h);

    // The same where v has just been kicked by h a. Kick and friction act in one time: each works along the
    // mean of the velocities before and after both, so that friction which holds against a force takes
    // nothing. Its impulse r m reckoned along the kicked velocity v, as if the kick had come first, takes -r
    // m (v + r / 2), which is h r m a / 2 too much, and that sums up.
    void rub_kicked(State& state, const Points& a, double h);

    // books `seconds` of the present power as energy gone
    void book(double seconds);

    // The same for a move from `from` to `x` with one velocity `v` [m/s] in the `seconds` up to `time`, after
    // the acceleration at its end. What forces take is reckoned half way, where |to|^2 - |from|^2 = 2 middle
    // . move: a spring that has merely turned takes nothing, while at the end the move is partly along it.
    void book_move(In from, In x, In v, double time, double seconds);

    // true if no force depends on velocity, nothing moves by itself and there is no contact: energy is
    // conserved
    bool is_conservative() const { return losses_.empty(); }
    // what is there of such things, in words
    const std::vector<std::string>& losses() const { return losses_; }

    double kinetic_energy(In v) const;                                // of free vertices [J]
    double potential_energy(In x, double time) const;                 // elastic, gravity, contact [J]
    StepBound bound(In x, ForceShare share = ForceShare::all) const;  // of forces but contact
    // ... of those alone whose damping is not linear
    StepBound nonlinear_bound(In x, ForceShare share = ForceShare::all) const;

    // For implicit methods: which vertices any force couples; K += -df/dx and B += -df/dv of all forces and
    // contact, symmetric. Only contact's K depends on v.
    Couplings couplings() const;
    // changes where contact at x couples others than before
    long couplings_version(In x, double time) const {
        return contact_ ? contact_->couplings_version(x, time) : 0;
    }
    void add_stiffness(In x, In v, double time, BlockMatrix& k) const;
    void add_damping(In x, In v, double time, BlockMatrix& b) const;
    // For those with a constant matrix: what bounds contact's and friction's K + B / c at this moment, per
    // vertex and the same for the three coordinates.
    void add_contact_majorant(In x, In v, double time, double c, Eigen::VectorXd& diagonal) const;

    const Model& model() const { return model_; }
    const std::vector<ActiveForce>& forces() const { return forces_; }
    Contact* contact() { return contact_.get(); }
    const Contact* contact() const { return contact_.get(); }
    const ObstacleContact::Result& touch() const { return touch_; }      // of the last acceleration
    double damping_beyond_bound() const { return power_.beyond_bound; }  // the same, of forces [1/s]
    const EnergyFlow& flow() const { return flow_; }
    void reset_flow(const EnergyFlow& flow) { flow_ = flow; }
    long sweeps() const { return sweeps_; }
    double contact_seconds() const { return contact_seconds_; }  // CPU [s]

private:
    // f = the sum of the `wanted` forces that work on padded vertices, each of which `add` adds to padded_f_
    // at padded_x_
    template <class Wanted, class Add>
    void sum_padded(In x, Wanted wanted, Points& f, Add add);
    // f = the sum of the `wanted` forces, all that they do
    template <class Wanted>
    Power sum_moving(In x, In v, double time, Wanted wanted, Points& f);
    void sum_conservative(In x, ForceShare share, Points& f);  // of forces but contact
    void sum_all(In x, In v, double time, ForceShare share, NormalDamping damping, Points& f);
    void finish(In v, Points& f);  // books the pins' power, makes accelerations of forces
    void to_acceleration(Points& f) const;

    const Model& model_;
    std::vector<ActiveForce> forces_;
    std::unique_ptr<Contact> contact_;
    std::vector<std::string> losses_;
    std::vector<int> pinned_;
    PaddedPoints padded_x_, padded_v_, padded_f_;  // scratch
    Points middle_, middle_f_;                     // scratch
    Power force_power_, power_;                    // of forces alone; with contact and pins
    EnergyFlow flow_;
    ObstacleContact::Result touch_;
    SmoothFriction friction_;
    long sweeps_ = 0;
    double contact_seconds_ = 0;
};

}  // namespace drape
