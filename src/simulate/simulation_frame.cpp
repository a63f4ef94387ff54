// How a frame is made: its steps, guarded against obstacles and against energy from nowhere, tried again with
// half the step where that did not hold.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/hash.h"
#include "base/timer.h"
#include "contact/self_contact.h"
#include "simulate/diagnosis.h"
#include "simulate/simulation.h"
#include "simulate/strain.h"

namespace drape {

namespace {

constexpr int most_halvings = 30;  // of a step that crossed into an obstacle or was not solved
constexpr int most_retries = 10;   // of a frame, each with half the step
// of a frame, over those planned as many times and besides: so short steps would go on for ever
constexpr long most_times_planned = 64, most_implicit_steps = 1000, most_explicit_steps = 200'000;
constexpr double instant = 1e-12;  // of the time so far: less is no step to make

}  // namespace

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
        if (solved && !touch.crossed && !(contact && contact->passed_through(before_, state_))) {
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

// Contact points keep their distance, and what lies between them: unless cloth is stretched so far that they
// lie apart farther than was foreseen, or the obstacle is smaller than what lies between them. A little of
// that is told; more than the contact's thickness is cloth in an obstacle.
void Simulation::look_for_penetration(FrameReport& report) const {
    const Contact* contact = dynamics_->contact();
    if (!contact) return;
    const double least = contact->least_distance(state_.x, state_.time);
    report.least_distance = std::min(report.least_distance, least);
    if (least >= -contact->thickness()) return;
    const double pushed = contact->least_distance(state_.x, state_.time, false);
    if (pushed < -contact->thickness())
        report.trouble = why_inside(-pushed, state_.time, largest_strain(setup_.model, state_.x));
}

FrameReport Simulation::advance() {
    const double began = thread_cpu_seconds();
    FrameReport report = next_frame();
    report.cpu_seconds = thread_cpu_seconds() - began;
    return report;
}

FrameReport Simulation::next_frame() {
    const State good = state_;
    const EnergyFlow good_flow = dynamics_->flow();
    FrameReport report;
    for (int retries = 0;; ++retries) {
        halvings_ = retries;
        report = try_frame();
        report.retries = retries;
        if (report.trouble.empty()) break;
        state_ = good;
        dynamics_->reset_flow(good_flow);
        if (!runs_away_ || retries == most_retries) break;
    }
    halvings_ = 0;
    if (report.trouble.empty()) look_for_penetration(report);
    if (!report.trouble.empty()) {
        state_ = good;
        dynamics_->reset_flow(good_flow);
        return report;
    }
    if (const Contact* contact = dynamics_->contact(); contact && contact->self())
        report.crossings = contact->crossings(state_.x, state_.time);
    ++frame_;
    weighed_ = true;
    report.time = state_.time;
    report.strain = largest_strain(setup_.model, state_.x);
    report.fastest = std::sqrt(state_.v.colwise().squaredNorm().maxCoeff());
    report.hash =
        hash_text(hash_bytes(state_.x.data(), sizeof(double) * static_cast<size_t>(state_.x.size())));
    return report;
}

FrameReport Simulation::try_frame() {
    FrameReport report;
    report.index = frame_ + 1;
    report.least_distance = INFINITY;
    const double end_time = report.index / setup_.frame_rate;
    choose_step();
    if (Contact* contact = dynamics_->contact()) contact->prepare(state_, step_);
    // without contact, whose energy depends on what it has listed
    guard_->begin_frame(state_, end_time - state_.time, weighed_ && !dynamics_->contact());
    weighed_ = false;
    integrator_->begin(*dynamics_, state_, step_);
    report.planned_steps = std::lround(1 / setup_.frame_rate / step_);
    report.shortest_step = step_;
    runs_away_ = false;
    const long most_steps = most_times_planned * report.planned_steps +
                            (method_->is_implicit() ? most_implicit_steps : most_explicit_steps);
    for (double left = end_time - state_.time; left > instant * end_time; left = end_time - state_.time) {
        const double wanted = left / std::ceil(left / allowed_step() * (1 - instant));
        const double h = wanted > instant * end_time ? guarded_step(wanted, report) : 0;
        ++report.steps;
        report.shortest_step = std::min(report.shortest_step, h);
        // so fast that no step is short enough, without contact
        runs_away_ = h == 0 && !(wanted > instant * end_time) && dynamics_->touch().contacts == 0;
        if (runs_away_) break;
        if (h == 0) {
            report.trouble = why_no_step(*dynamics_, state_.time);
            return report;
        }
        if (setup_.stop && setup_.stop())
            throw Error(cat("stopped within frame ", report.index), Exit::interrupted);
        if (report.steps > most_steps) {
            report.trouble = why_no_end(*dynamics_, state_, report.steps, h);
            return report;
        }
        runs_away_ = !guard_->step_holds(state_.v);
        if (runs_away_) break;
    }
    if (!runs_away_) {
        integrator_->end(*dynamics_, state_, step_);
        runs_away_ = !state_.x.allFinite() || !(guard_->gain(state_) <= Guard::most_gain);
    }
    if (runs_away_)
        report.trouble = why_it_ran_away(*dynamics_, state_, {step_, longest_});
    else if ((state_.x - setup_.start.x).colwise().norm().maxCoeff() > left_out_gap_)
        report.trouble = cat("cloth travelled farther than ", left_out_gap_, " m by t = ", end_time,
                             " s, where an obstacle was left out of contact");
    state_.time = end_time;
    return report;
}

}  // namespace drape
