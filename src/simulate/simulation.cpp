#include "simulate/simulation.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/hash.h"
#include "base/names.h"
#include "base/timer.h"
#include "simulate/reach.h"
#include "simulate/strain.h"

namespace drape {

namespace {

constexpr double margin = 0.85;          // of the longest stable step that is used
constexpr double widest_margin = 0.98;   // ... by a pass that is there to be coarser
constexpr double measured_excess = 1.1;  // a measured fastest mode is taken to be this much faster
constexpr int most_halvings = 30;        // of a step that crossed into an obstacle or was not solved

std::string piece_of(const Model& model, std::string_view stage, size_t cloth) {
    return model.cloths.size() > 1 ? cat(stage, " (cloth ", cloth + 1, ")") : std::string(stage);
}

}  // namespace

Simulation::Simulation(Setup setup) : setup_(std::move(setup)), state_(setup_.start) {
    place_pins(setup_.model, state_);
    build();
    if (setup_.method.empty())
        choose_method();
    else
        take_method(setup_.method, setup_.because);
}

void Simulation::take_method(std::string_view method, std::string because) {
    method_ = &method_named(method);
    chosen_because_ = std::move(because);
    if (method_->conservative_only() && !dynamics_->is_conservative())
        throw Error(cat("method ", method, " is for scenes that conserve energy; this one has ",
                        joined(dynamics_->losses()), " (verlet, rk4 and embedded_rk take any)"));
    integrator_ = method_->make();
    choose_step();
}

void Simulation::build() {
    const Model& model = setup_.model;
    std::vector<ActiveForce> forces;
    for (const ForceKind& kind : force_kinds()) {
        for (size_t c = 0; c < model.cloths.size(); ++c) {
            MadeForce made = kind.make(model.cloths[c], setup_.world);
            const std::string stage = piece_of(model, kind.name, c);
            if (made.force) {
                plan_.use(stage, made.because);
                forces.push_back({stage, std::move(made.force), 0});
            } else {
                plan_.leave_out(stage, made.because);
            }
        }
    }
    const double duration = setup_.frames / setup_.frame_rate;
    const double reach = travel_allowance(model, state_, setup_.world, duration);
    std::vector<Obstacle> within_reach;
    if (setup_.obstacles.empty()) plan_.leave_out("contact", "no obstacle in the scene");
    for (size_t i = 0; i < setup_.obstacles.size(); ++i) {
        const Obstacle& obstacle = setup_.obstacles[i];
        const std::string stage = cat("contact with obstacle ", i + 1, " (", obstacle.kind, ")");
        const double gap = clearance(state_, obstacle);
        if (gap > reach) {
            plan_.leave_out(stage,
                            cat("out of reach: ", gap, " m away, cloth travels at most ", reach, " m"));
            left_out_gap_ = std::min(left_out_gap_, gap);
        } else {
            plan_.use(stage, "within reach of the cloth");
            within_reach.push_back(obstacle);
            rubs_ = rubs_ || obstacle.friction > 0;
        }
    }
    std::unique_ptr<Contact> contact;
    if (!within_reach.empty()) {
        contact = std::make_unique<Contact>(model, within_reach, setup_.world.gravity, state_, duration);
        lifted_ = contact->lift_out(state_.x);
    }
    dynamics_ = std::make_unique<Dynamics>(model, std::move(forces), std::move(contact));
}

void Simulation::choose_step() {
    const ForceShare share = method_->explicit_share();
    spectrum_ = gershgorin_spectrum(*dynamics_, state_.x, share);
    guaranteed_ = method_->longest_step(spectrum_);
    spectrum_.omega =
        std::min(spectrum_.omega, measured_excess * measured_omega(*dynamics_, state_.x, share));
    longest_ = method_->longest_step(spectrum_);
    const double usual = usual_step(*method_);
    double wanted = setup_.step.value_or(usual);
    if (setup_.keep_stable && !method_->is_implicit()) wanted = std::min(wanted, margin * longest_);
    step_ = 1 / setup_.frame_rate / steps_a_frame(wanted);
    pace_ = step_ / usual;
    // springs set no limit there, contact does
    if (method_->projects_springs) pace_ = std::min(pace_, 1.0);
}

double Simulation::usual_step(const Method& method) const {
    if (method.is_implicit()) return usual_implicit_step;
    const double stable = margin * method.longest_step(spectrum_);
    return method.projects_springs ? std::min(stable, usual_projecting_step) : stable;
}

double Simulation::steps_a_frame(double wanted) const {
    const double frame_time = 1 / setup_.frame_rate;
    const double steps = wanted < frame_time ? std::ceil(frame_time / wanted * (1 - 1e-12)) : 1;
    if (setup_.refine == 1) return steps;
    const double other = std::ceil(steps * setup_.refine * (1 - 1e-12));
    if (setup_.refine > 1) return std::max(other, steps + 1);
    const double fewer = std::min(other, steps - 1);
    const bool stable = fewer > 0 && frame_time / fewer <= std::max(widest_margin * longest_, wanted);
    return stable ? fewer : steps + std::ceil(steps / 10);
}

double Simulation::allowed_step() const {
    if (!dynamics_->contact()) return step_;
    const ContactLimits& limits = dynamics_->touch().limits;
    double allowed = std::min(step_, pace_ * margin * method_->longest_step(with_contact(spectrum_, limits)));
    // implicit steps find their own way up to the barrier
    if (limits.closing_rate > 0 && !method_->is_implicit())
        allowed = std::min(allowed, std::min(pace_, 1.0) / limits.closing_rate);
    return allowed;
}

Energies Simulation::energies() const {
    return {dynamics_->kinetic_energy(state_.v), dynamics_->potential_energy(state_.x, state_.time)};
}

double Simulation::guarded_step(double h, FrameReport& report) {
    Contact* contact = dynamics_->contact();
    // nothing to guard against: an explicit step without contact always arrives
    if (!contact && !method_->is_implicit()) return integrator_->step(*dynamics_, state_, h) ? h : 0;
    // for the longest step: a point too far to be listed would not have shortened it, whenever the list was
    // made
    if (contact) contact->prepare(state_, step_);
    before_ = state_;
    const EnergyFlow flow = dynamics_->flow();
    for (int halving = 0; halving <= most_halvings; ++halving, h /= 2) {
        const bool solved = integrator_->step(*dynamics_, state_, h);
        const ObstacleContact::Result& touch = dynamics_->touch();
        if (solved && !touch.crossed) {
            report.contacts = std::max(report.contacts, touch.contacts);
            if (touch.contacts > 0)
                report.least_distance = std::min(report.least_distance, touch.least_distance);
            return h;
        }
        state_ = before_;
        dynamics_->reset_flow(flow);
        integrator_->begin(*dynamics_, state_, h / 2);
    }
    return 0;
}

FrameReport Simulation::advance() {
    const double began = thread_cpu_seconds();
    FrameReport report = next_frame();
    report.cpu_seconds = thread_cpu_seconds() - began;
    return report;
}

FrameReport Simulation::next_frame() {
    FrameReport report;
    report.index = frame_ + 1;
    report.least_distance = INFINITY;
    const State good = state_;
    const EnergyFlow good_flow = dynamics_->flow();
    const double end_time = report.index / setup_.frame_rate;

    choose_step();
    if (Contact* contact = dynamics_->contact()) contact->prepare(state_, step_);
    integrator_->begin(*dynamics_, state_, step_);
    report.planned_steps = std::lround(1 / setup_.frame_rate / step_);
    report.shortest_step = step_;
    double h = step_;
    for (double left = end_time - state_.time; left > 1e-12 * end_time; left = end_time - state_.time) {
        const double wanted = left / std::ceil(left / allowed_step() * (1 - 1e-12));
        h = guarded_step(wanted, report);
        ++report.steps;
        report.shortest_step = std::min(report.shortest_step, h);
        if (h == 0 || !(state_.v.cwiseAbs().maxCoeff() < 1e9)) break;
    }
    if (h > 0) integrator_->end(*dynamics_, state_, step_);

    const bool finite = state_.x.allFinite() && state_.v.allFinite();
    if (h == 0)
        report.trouble =
            dynamics_->touch().crossed
                ? cat("cloth was pushed into an obstacle at t = ", state_.time,
                      " s and no step, however short, keeps it out")
                : cat("no step from t = ", state_.time, " s, however short, could be solved for");
    else if (!finite || !(state_.v.cwiseAbs().maxCoeff() < 1e9))
        report.trouble = cat("velocities left all bounds before t = ", end_time, " s with steps of ", step_,
                             " s (the longest stable one is ", longest_, " s)");
    else if ((state_.x - setup_.start.x).colwise().norm().maxCoeff() > left_out_gap_)
        report.trouble = cat("cloth travelled farther than ", left_out_gap_, " m by t = ", end_time,
                             " s, where an obstacle was left out of contact");
    if (!report.trouble.empty()) {
        state_ = good;
        dynamics_->reset_flow(good_flow);
        return report;
    }
    state_.time = end_time;
    ++frame_;
    if (dynamics_->contact())
        report.least_distance =
            std::min(report.least_distance, dynamics_->contact()->least_distance(state_.x, state_.time));
    report.time = state_.time;
    report.strain = largest_strain(setup_.model, state_.x);
    report.fastest = std::sqrt(state_.v.colwise().squaredNorm().maxCoeff());
    report.hash =
        hash_text(hash_bytes(state_.x.data(), sizeof(double) * static_cast<size_t>(state_.x.size())));
    return report;
}

void Simulation::save(ByteWriter& out) const {
    out.put(frame_);
    out.put(state_.x);
    out.put(state_.v);
    out.put(state_.time);
    out.put(dynamics_->flow().dissipated);
    out.put(dynamics_->flow().driven);
}

bool Simulation::restore(ByteReader& in) {
    const int frame = in.take<int>();
    State state;
    state.x = in.take_points();
    state.v = in.take_points();
    state.time = in.take<double>();
    EnergyFlow flow;
    flow.dissipated = in.take<double>();
    flow.driven = in.take<double>();
    if (!in.ok() || state.x.cols() != state_.x.cols() || state.v.cols() != state_.v.cols()) return false;
    frame_ = frame;
    state_ = state;
    dynamics_->reset_flow(flow);
    return true;
}

}  // namespace drape
