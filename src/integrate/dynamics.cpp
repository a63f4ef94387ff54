#include "integrate/dynamics.h"

#include "base/timer.h"

namespace drape {

namespace {

bool is_in(ForceShare share, const Force& force) {
    return share == ForceShare::all || !force.projects();
}

}  // namespace

Dynamics::Dynamics(const Model& model, std::vector<ActiveForce> forces, std::unique_ptr<Contact> contact)
    : model_(model), forces_(std::move(forces)), contact_(std::move(contact)) {
    std::string dissipating;
    for (const ActiveForce& active : forces_)
        if (!active.force->is_conservative()) dissipating += (dissipating.empty() ? "" : ", ") + active.stage;
    if (!dissipating.empty()) losses_.push_back("damping or wind (" + dissipating + ")");
    if (contact_) losses_.push_back("contact");
    if (has_moving_pins(model)) losses_.push_back("moving pins");
    for (int i = 0; i < model.vertices(); ++i)
        if (model.inverse_mass[i] == 0) pinned_.push_back(i);
}

void Dynamics::to_acceleration(Points& f) const {
    double* value = f.data();
    for (Eigen::Index i = 0; i < f.cols(); ++i, value += 3) {
        const double inverse_mass = model_.inverse_mass[i];
        value[0] *= inverse_mass;
        value[1] *= inverse_mass;
        value[2] *= inverse_mass;
    }
}

template <class Wanted, class Add>
void Dynamics::sum_padded(In x, Wanted wanted, Points& f, Add add) {
    bool found = false;
    for (const ActiveForce& active : forces_) {
        const PaddedForce* force = active.force->padded();
        if (!force || !wanted(*force)) continue;
        if (!found) {
            pad(x, padded_x_);
            padded_f_.setZero(4, x.cols());
        }
        found = true;
        add(*force);
    }
    if (found)
        unpad(padded_f_, f);
    else
        f.setZero(3, x.cols());
}

void Dynamics::sum_conservative(In x, ForceShare share, Points& f) {
    ++sweeps_;
    sum_padded(
        x, [&](const Force& force) { return is_in(share, force); }, f,
        [&](const PaddedForce& force) { force.add_padded_conservative(padded_x_, padded_f_); });
    for (const ActiveForce& active : forces_) {
        if (!is_in(share, *active.force)) continue;
        if (!active.force->padded()) active.force->add_conservative(x, f);
        ++active.calls;
    }
}

void Dynamics::acceleration_without_contact(In x, Points& a, ForceShare share) {
    sum_conservative(x, share, a);
    to_acceleration(a);
}

void Dynamics::conservative_acceleration(In x, double time, Points& a) {
    sum_conservative(x, ForceShare::all, a);
    if (contact_) {
        const ThreadCpuScope timer(contact_seconds_);
        contact_->add_conservative(x, time, a);
    }
    to_acceleration(a);
}

template <class Wanted>
Power Dynamics::sum_moving(In x, In v, double time, Wanted wanted, Points& f) {
    Power power;
    bool moving = false;  // whether velocities are padded: only damping asks for them
    sum_padded(x, wanted, f, [&](const PaddedForce& force) {
        if (force.is_conservative()) {
            force.add_padded_conservative(padded_x_, padded_f_);
            return;
        }
        if (!moving) pad(v, padded_v_);
        moving = true;
        power += force.add_padded(padded_x_, padded_v_, padded_f_);
    });
    for (const ActiveForce& active : forces_) {
        if (wanted(*active.force) && !active.force->padded()) power += active.force->add_all(x, v, time, f);
    }
    return power;
}

void Dynamics::linearly_damped_acceleration(In x, In v, Points& a, ForceShare share) {
    const auto linear = [&](const Force& force) {
        return is_in(share, force) && !force.is_conservative() && force.is_linear_in_velocity();
    };
    sum_moving(x, v, 0, linear, a);
    to_acceleration(a);
}

void Dynamics::sum_all(In x, In v, double time, ForceShare share, NormalDamping damping, Points& f) {
    ++sweeps_;
    const auto wanted = [&](const Force& force) { return is_in(share, force); };
    power_ = force_power_ = sum_moving(x, v, time, wanted, f);
    for (const ActiveForce& active : forces_) active.calls += wanted(*active.force);
    if (contact_) {
        const ThreadCpuScope timer(contact_seconds_);
        touch_ = contact_->add_all(x, v, time, f, damping);
        power_ += {.dissipated = touch_.dissipated, .driven = touch_.driven};
    }
}

void Dynamics::finish(In v, Points& f) {
    // what holds a pin works against the cloth's pull where the pin moves
    for (const int i : pinned_) power_.driven -= f.col(i).dot(v.col(i));
    to_acceleration(f);
}

void Dynamics::acceleration(In x, In v, double time, Points& a) {
    sum_all(x, v, time, ForceShare::all, NormalDamping::force, a);
    finish(v, a);
}

void Dynamics::acceleration_to_kick(In x, In v, double time, Points& a, ForceShare share) {
    sum_all(x, v, time, share, NormalDamping::impulse, a);
    finish(v, a);
}

void Dynamics::acceleration_with_friction(In x, In v, double time, Points& a) {
    sum_all(x, v, time, ForceShare::all, NormalDamping::force, a);
    const ContactWork power = friction_.add_force(v, a);
    power_ += {.dissipated = power.dissipated, .driven = power.driven};
    finish(v, a);
}

void Dynamics::hold_friction() {
    if (contact_) friction_.hold(*contact_);
}

void Dynamics::project(WeightedPoints& x, const WeightedPoints& before, double h) {
    for (const ActiveForce& active : forces_) {
        if (!active.force->projects()) continue;
        active.force->project(x, before, h);
        ++active.calls;
    }
}

void Dynamics::rub(State& state, double h) {
    if (!contact_) return;
    const ThreadCpuScope timer(contact_seconds_);
    const ContactWork work = contact_->rub(state.v, h);
    flow_.dissipated += work.dissipated;
    flow_.driven += work.driven;
}

void Dynamics::rub_kicked(State& state, const Points& a, double h) {
    if (!contact_ || touch_.contacts == 0) return;
    middle_ = state.v;
    rub(state, h);
    double work = 0;
    for (Eigen::Index i = 0; i < a.cols(); ++i)
        work += model_.mass[i] * a.col(i).dot(state.v.col(i) - middle_.col(i));
    flow_.dissipated += h / 2 * work;
}

void Dynamics::book(double seconds) {
    flow_.dissipated += power_.dissipated * seconds;
    flow_.driven += power_.driven * seconds;
}

void Dynamics::book_move(In from, In x, In v, double time, double seconds) {
    book(seconds);
    if (force_power_.dissipated == 0 && force_power_.driven == 0) return;
    middle_ = 0.5 * (from + x);
    const auto moving = [](const Force& force) { return !force.is_conservative(); };
    const Power half_way = sum_moving(middle_, v, time - seconds / 2, moving, middle_f_);
    flow_.dissipated += (half_way.dissipated - force_power_.dissipated) * seconds;
    flow_.driven += (half_way.driven - force_power_.driven) * seconds;
}

double Dynamics::kinetic_energy(In v) const {
    double energy = 0;
    for (Eigen::Index i = 0; i < v.cols(); ++i)
        if (model_.inverse_mass[i] > 0) energy += 0.5 * model_.mass[i] * v.col(i).squaredNorm();
    return energy;
}

double Dynamics::potential_energy(In x, double time) const {
    double energy = contact_ ? contact_->energy(x, time) : 0;
    for (const ActiveForce& active : forces_) energy += active.force->energy(x);
    return energy;
}

Couplings Dynamics::couplings() const {
    Couplings couplings;
    for (const ActiveForce& active : forces_) active.force->add_couplings(couplings);
    if (contact_) contact_->add_couplings(couplings);
    return couplings;
}

void Dynamics::add_stiffness(In x, In v, double time, BlockMatrix& k) const {
    for (const ActiveForce& active : forces_) active.force->add_stiffness(x, k);
    if (contact_) contact_->add_stiffness(x, v, time, k);
}

void Dynamics::add_damping(In x, In v, double time, BlockMatrix& b) const {
    for (const ActiveForce& active : forces_) active.force->add_damping(x, v, time, b);
    if (contact_) contact_->add_damping(x, v, time, b);
}

void Dynamics::add_contact_majorant(In x, In v, double time, double c, Eigen::VectorXd& diagonal) const {
    if (!contact_) return;
    contact_->add_majorant(x, v, time, c, diagonal);
    friction_.add_majorant(v, c, diagonal);
}

StepBound Dynamics::bound(In x, ForceShare share) const {
    StepBound bound(model_.vertices());
    for (const ActiveForce& active : forces_)
        if (is_in(share, *active.force)) active.force->add_bound(x, bound);
    return bound;
}

StepBound Dynamics::nonlinear_bound(In x, ForceShare share) const {
    StepBound bound(model_.vertices());
    for (const ActiveForce& active : forces_)
        if (is_in(share, *active.force) && !active.force->is_linear_in_velocity())
            active.force->add_bound(x, bound);
    return bound;
}

}  // namespace drape
