#include "simulate/simulation.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/names.h"
#include "contact/self_contact.h"
#include "simulate/reach.h"
#include "simulate/strain.h"

namespace drape {

namespace {

constexpr double margin = 0.85;          // of the longest stable step that is used
constexpr double widest_margin = 0.98;   // ... by a pass that is there to be coarser
constexpr double measured_excess = 1.1;  // measured modes are taken to be this much faster, more damped
constexpr double near_rest = 0.5;        // the largest strain at which damping is measured
// Steps a frame that no damping would save: measuring it takes up to 25 sweeps and saves half of them.
constexpr double worth_measuring = 50;

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
    if (const Contact* contact = dynamics_->contact(); contact && contact->self() && !method_->meets_itself)
        throw Error(cat(
            "method ", method, " cannot do ",
            contact->self()->surfaces().meshes() > 0 ? "obstacles that are meshes" : "self_contact = true",
            " (verlet and backward_euler can)"));
    integrator_ = method_->make();
    // where springs project, nobody counts what moving pins pull at them
    const bool drive = !method_->projects_springs || !has_moving_pins(setup_.model);
    guard_.emplace(*dynamics_, setup_.world.gravity, Books{drive, !method_->projects_springs});
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
    const bool meets_itself = std::any_of(model.cloths.begin(), model.cloths.end(),
                                          [](const Cloth& cloth) { return cloth.self_contact; });
    if (meets_itself)
        plan_.use("self contact", "asked for");
    else
        plan_.leave_out("self contact", "no cloth has self_contact = true");
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
    for (const Cloth& cloth : model.cloths)
        rubs_ = rubs_ || (cloth.self_contact && cloth.fabric.friction > 0);
    std::unique_ptr<Contact> contact;
    if (!within_reach.empty() || meets_itself) {
        contact = std::make_unique<Contact>(model, within_reach, setup_.world.gravity, state_, duration);
        lifted_ = contact->lift_out(state_.x);
        contact->prepare(state_, 0);  // the energy at the start is asked for before any step
    }
    dynamics_ = std::make_unique<Dynamics>(model, std::move(forces), std::move(contact));
}

void Simulation::choose_step() {
    const ForceShare share = method_->explicit_share();
    spectrum_ = gershgorin_spectrum(*dynamics_, state_.x, share);
    guaranteed_ = method_->longest_step(spectrum_);
    spectrum_.omega =
        std::min(spectrum_.omega, measured_excess * measured_omega(*dynamics_, state_.x, share));
    const double frame_time = 1 / setup_.frame_rate;
    const auto steps = [&](double gamma) {
        return frame_time / (margin * method_->longest_step({spectrum_.omega, gamma}));
    };
    // Far from rest the next pose is unlike this one: a cloth that starts as a point damps nothing yet.
    if (steps(spectrum_.gamma) - steps(0) > worth_measuring &&
        largest_strain(setup_.model, state_.x) < near_rest)
        spectrum_.gamma =
            std::min(spectrum_.gamma, measured_excess * measured_gamma(*dynamics_, state_.x, share));
    longest_ = method_->longest_step(spectrum_);
    const double usual = usual_step(*method_);
    double wanted = setup_.step.value_or(usual);
    if (setup_.keep_stable && !method_->is_implicit()) wanted = std::min(wanted, margin * longest_);
    step_ = frame_time / (steps_a_frame(wanted) * std::exp2(halvings_));
    pace_ = step_ / std::min(usual, frame_time);
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
    Spectrum now = spectrum_;
    now.gamma += dynamics_->damping_beyond_bound();
    double allowed = step_;
    if (now.gamma > spectrum_.gamma) allowed = std::min(allowed, pace_ * margin * method_->longest_step(now));
    if (!dynamics_->contact()) return allowed;
    const ContactLimits& limits = dynamics_->touch().limits;
    allowed = std::min(allowed, pace_ * margin * method_->longest_step(with_contact(now, limits)));
    // implicit steps find their own way up to the barrier
    if (limits.closing_rate > 0 && !method_->is_implicit())
        allowed = std::min(allowed, std::min(pace_, 1.0) / limits.closing_rate);
    return allowed;
}

Energies Simulation::energies() const {
    return {dynamics_->kinetic_energy(state_.v), dynamics_->potential_energy(state_.x, state_.time)};
}

void Simulation::save(ByteWriter& out) const {
    out.put(frame_);
    out.put(state_.x);
    out.put(state_.v);
    out.put(state_.time);
    out.put(dynamics_->flow().dissipated);
    out.put(dynamics_->flow().driven);
    for (const double step : {step_, longest_, guaranteed_}) out.put(step);
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
    for (double* step : {&step_, &longest_, &guaranteed_}) *step = in.take<double>();
    if (!in.ok() || state.x.cols() != state_.x.cols() || state.v.cols() != state_.v.cols()) return false;
    // no run saves anything else: what is wrong here would not be told apart from a simulation gone wrong
    if (frame < 0 || frame > setup_.frames || !state.x.allFinite() || !state.v.allFinite() ||
        !(std::abs(state.time * setup_.frame_rate - frame) < 1e-6 * (1 + frame)))
        return false;
    frame_ = frame;
    state_ = state;
    weighed_ = false;
    dynamics_->reset_flow(flow);
    // a run that is over but for its pictures asks what its last frame left
    if (Contact* contact = dynamics_->contact()) contact->prepare(state_, step_);
    return true;
}

}  // namespace drape
