#include "simulate/budgeted_delivery.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "simulate/ways.h"

namespace drape {

namespace {

// What a second pass beside the first adds to the wall time of both: little on a core of its own.
constexpr double beside_on_own_core = 1.1, beside_on_same_core = 1.9;
constexpr int trial_steps = 100;
constexpr double spare_before_contact = 0.3, spare_before_first_picture = 0.5;
// More steps than so many times the stable ones gain nothing that round-off leaves.
constexpr double finest_refinement = 256;

struct Look {
    double step_seconds = 0;  // wall, of one pass [s]
    double steps = 0;         // stable ones, of the whole run
};

// What a step of the way takes, by a few at the start of the scene.
Look look_at(const Way& way, Setup setup, int frames, const Budget& budget) {
    setup = pass_along(way, std::move(setup), 1);
    const double step = Simulation(setup).step();
    Look look;
    look.steps = frames / setup.frame_rate / step;
    setup.frame_rate = 1 / (trial_steps * step);
    Simulation trial(std::move(setup));
    const double began = budget.clock();
    const auto steps = static_cast<double>(trial.advance().steps);
    look.step_seconds = (budget.clock() - began) / steps;
    return look;
}

// The usual way if the budget has time for its longest step, one of higher order if it has time for many
// more, else the rough one; with a second pass if there is time for that.
Approach approach_to(const Setup& setup, const DeliveryOptions& options, int frames) {
    const Ways ways = ways_within_budget(setup);
    const Budget& budget = *options.budget;
    const double beside = options.threads > 1 ? beside_on_own_core : beside_on_same_core;
    const Look usual = look_at(ways.usual, setup, frames, budget);
    const double once = usual.steps * usual.step_seconds, left = budget.seconds - budget.clock();
    Approach approach{ways.usual, options.estimate, usual.step_seconds};
    if (ways.rough && left < once) {
        approach.way = *ways.rough;
        approach.step_seconds = look_at(*ways.rough, setup, frames, budget).step_seconds;
    } else if (left < beside * once) {
        approach.estimate = false;
    } else if (ways.fine && left > beside * once * seconds_to_judge(*ways.fine) / ways.usual.seconds) {
        approach.way = *ways.fine;
        approach.step_seconds = look_at(*ways.fine, setup, frames, budget).step_seconds;
    }
    if (approach.estimate) approach.step_seconds *= beside;
    return approach;
}

}  // namespace

BudgetedDelivery::BudgetedDelivery(Setup setup, const DeliveryOptions& options)
    : setup_(std::move(setup)),
      options_(options),
      frames_(options.frames > 0 ? options.frames : setup_.frames) {
    setup_.keep_stable = true;
    options_.budget->clock = [this, elapsed = options.budget->clock] { return before_ + elapsed(); };
    take(approach_to(setup_, options_, frames_));
}

void BudgetedDelivery::take(const Approach& approach) {
    approach_ = approach;
    DeliveryOptions inner = options_;
    if (options_.estimate && !approach.estimate) inner.no_estimate_because = "the budget has no time for one";
    inner.estimate = approach.estimate;
    inner_ = std::make_unique<StreamedDelivery>(pass_along(approach.way, setup_, 1), inner);
    const Simulation& simulation = inner_->simulation();
    most_steps_ = finest_refinement / simulation.frame_rate() / simulation.step();
    waits_for_contact_ = simulation.has_contact();
    pacer_.emplace(*options_.budget, frames_, approach.step_seconds);
}

std::optional<FrameReport> BudgetedDelivery::advance() {
    pacer_->begin_frame();
    const double spare = frame() == 0         ? spare_before_first_picture
                         : waits_for_contact_ ? spare_before_contact
                                              : 0.0;
    const double steps = std::clamp(std::floor(pacer_->affordable_steps(spare)), 1.0, most_steps_);
    inner_->pace(steps);
    std::optional<FrameReport> report = inner_->advance();
    pacer_->end_frame(static_cast<double>(report->planned_steps));
    if (report->contacts > 0) waits_for_contact_ = false;
    return report;
}

std::string BudgetedDelivery::save() const {
    ByteWriter out;
    out.put(options_.budget->clock());
    out.put(approach_.way.method);
    out.put(approach_.estimate);
    out.put(pacer_->step_seconds());
    out.put(waits_for_contact_);
    out.put(inner_->save());
    return std::move(out).bytes();
}

bool BudgetedDelivery::restore(std::string_view bytes) {
    ByteReader in(bytes);
    before_ = in.take<double>();
    Approach approach;
    approach.way.method = in.take_text();
    approach.way.because = "the run that is gone on with took it";
    approach.estimate = in.take<bool>();
    approach.step_seconds = in.take<double>();
    const bool waits_for_contact = in.take<bool>();
    const std::string inner = in.take_text();
    if (!in.at_end()) return false;
    take(approach);
    if (!inner_->restore(inner)) return false;
    waits_for_contact_ = waits_for_contact;
    pacer_.emplace(*options_.budget, frames_ - frame(), approach.step_seconds);
    return true;
}

}  // namespace drape
