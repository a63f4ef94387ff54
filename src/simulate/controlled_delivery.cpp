#include "simulate/controlled_delivery.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "simulate/side_by_side.h"
#include "simulate/twin.h"

namespace drape {

namespace {

constexpr double least_refinement = 1.3, most_refinement = 8, most_in_contact = 4;
constexpr double aim = 0.6;    // of the tolerance, when the next pass's steps are chosen
constexpr double idle = 0.75;  // a pass whose error is more than this of the last one's was idle
constexpr int most_idle = 2, most_failed = 3, most_passes = 12;
constexpr double least_order = 0.5;
// Of the order that a method has where nothing jumps, at least, when the next pass is planned: errors of
// passes so coarse that they are as large as they can be tell a lower one.
constexpr double planned_order = 0.5;

}  // namespace

ControlledDelivery::ControlledDelivery(Setup setup, const DeliveryOptions& options)
    : setup_(std::move(setup)),
      threads_(options.threads),
      frames_(options.frames > 0 ? options.frames : setup_.frames),
      tolerance_(*options.tolerance) {
    mean_edge_ = mean_edge(setup_.model);
    account_.asked = tolerance_;
    account_.how = "whole passes with ever more steps, compared at every frame (Richardson)";
    Ways ways = ways_to(setup_, tolerance_);
    if (ways.rough) rows_.push_back(std::move(*ways.rough));
    usual_row_ = static_cast<int>(rows_.size());
    rows_.push_back(std::move(ways.usual));
    if (ways.fine) rows_.push_back(std::move(*ways.fine));
    start_row(0);
    shown_ = running_->state();
}

void ControlledDelivery::start_row(int row) {
    row_ = row;
    row_steps_.clear();
    row_distance_.clear();
    distance_.clear();
    before_ = {};
    idle_ = failed_ = 0;
    account_.floor = account_.floor_from = NAN;
    start_pass(1);
    start_twin();
}

void ControlledDelivery::start_twin() {
    Setup twin = pass_along(way(), setup_, now_.refine);
    twin.start = moved_a_little(twin.model, twin.start);
    twin_ = std::make_unique<Simulation>(std::move(twin));
    floor_.clear();
}

void ControlledDelivery::start_pass(double refine) {
    now_ = {};
    now_.refine = refine;
    now_.jumps = has_jumping_forces(setup_.model);
    running_ = std::make_unique<Simulation>(pass_along(way(), setup_, refine));
    account_.passes.emplace_back();
    account_.passes.back().purpose = before_.x.empty() ? "first look" : "more steps";
}

std::optional<FrameReport> ControlledDelivery::advance() {
    if (accepted_) return deliver();
    run_frame();
    return std::nullopt;
}

void ControlledDelivery::run_frame() {
    FrameReport report;
    if (twin_) {
        FrameReport other;
        std::tie(report, other) = advance_both(*running_, *twin_, threads_);
        account_.seconds += other.cpu_seconds;
        if (!other.trouble.empty())
            twin_.reset();
        else if (report.trouble.empty())
            floor_.push_back(distance_between(running_->state().x, twin_->state().x).rms);
    } else {
        report = running_->advance();
    }
    PassRecord& record = account_.passes.back();
    record.method = running_->method().name;
    record.step = running_->step();
    record.steps += report.steps;
    record.sweeps = running_->sweeps();
    record.cpu_seconds += report.cpu_seconds;
    now_.steps += static_cast<double>(report.steps);
    now_.jumps = now_.jumps || report.contacts > 0;
    const bool failed = !report.trouble.empty();
    now_.frames.push_back(std::move(report));
    if (!failed) {
        now_.x.push_back(running_->state().x);
        if (!before_.x.empty())
            distance_.push_back(distance_between(now_.x.back(), before_.x[now_.x.size() - 1]));
    } else if (row_ < usual_row_) {
        return start_row(usual_row_);
    } else if (++failed_ < most_failed) {
        // a pass that went wrong says nothing but that it needs shorter steps
        distance_.clear();
        start_pass(2 * now_.refine);
        if (before_.x.empty()) start_twin();
        return;
    }
    if (failed)
        accept(false);
    else if (running_->frame() == frames_)
        end_pass();
}

void ControlledDelivery::end_pass() {
    row_steps_.push_back(now_.steps);
    if (before_.x.empty()) {
        note_floor();
        keep_pass();
        return start_pass(before_.refine * way().refinement);
    }
    // those that can be predicted show the order, if there are any
    const double predictable = worst_distance(true);
    row_distance_.push_back(predictable > 0 ? predictable : worst_distance(false));
    judge();
}

void ControlledDelivery::keep_pass() {
    before_ = std::move(now_);
    before_record_ = account_.passes.size() - 1;
}

void ControlledDelivery::note_floor() {
    twin_.reset();
    for (size_t k = 0; k < floor_.size(); ++k) {
        account_.floor = std::fmax(account_.floor, floor_[k]);
        if (floor_[k] > tolerance_ && std::isnan(account_.floor_from))
            account_.floor_from = now_.frames[k].time;
    }
}

double ControlledDelivery::order_here(bool jumps) const {
    return running_->method().order_where(running_->dynamics().is_conservative(), jumps);
}

double ControlledDelivery::worst_distance(bool above_floor_only) const {
    double worst = 0;
    for (size_t k = 0; k < distance_.size(); ++k)
        if (!above_floor_only || k >= floor_.size() || floor_[k] <= tolerance_)
            worst = std::max(worst, distance_[k].rms);
    return worst;
}

void ControlledDelivery::judge() {
    const size_t n = row_steps_.size();
    const double most_order = order_here(now_.jumps || before_.jumps);
    double order = most_order;  // two passes cannot tell
    if (n >= 3)
        order = observed_order({row_steps_[n - 3], row_steps_[n - 2], row_steps_[n - 1]},
                               row_distance_[n - 3], row_distance_[n - 2], least_order, most_order);
    share_ = error_share(now_.steps, before_.steps, order);
    const double apart = worst_distance(false);
    const double worst =
        stated_share(apart, share_, mean_edge_) * apart + round_off(now_.x.back(), now_.steps);
    double& last_error = account_.passes[before_record_].error_rms;
    last_error = std::fmax(last_error, error_share(before_.steps, now_.steps, order) * apart);
    account_.passes.back().error_rms = worst;
    if (n >= way().least_passes && worst <= tolerance_) return accept(true);

    // no refinement makes frames below the floor predictable
    const double predictable = std::min(worst, share_ * worst_distance(true));
    if (n >= way().least_passes && predictable <= tolerance_ && !std::isnan(account_.floor_from))
        return accept(true);
    idle_ = worst > idle * last_error && n >= 3 ? idle_ + 1 : 0;
    const bool stuck = idle_ >= most_idle || account_.passes.size() >= most_passes;
    // a rough way's order sets in late: how far it has to go is told by the one it will have
    const bool rough = row_ < usual_row_;
    if (stuck && !rough) return accept(false);
    double expected = n >= 3 && !rough ? order : most_order;
    if (!now_.jumps) expected = std::max(expected, planned_order * most_order);
    const double driving =
        (predictable > 0 ? predictable : worst) * (error_share(now_.steps, before_.steps, expected) / share_);
    const double needed = now_.refine * std::pow(driving / (aim * tolerance_), 1 / expected);
    const int row = stuck ? usual_row_ : better_row(needed);
    if (row != row_) return start_row(row);
    const double most = now_.jumps ? most_in_contact : most_refinement;
    const double refinement =
        rough ? way().refinement : std::clamp(needed / now_.refine, least_refinement, most);
    keep_pass();
    distance_.clear();
    start_pass(before_.refine * refinement);
}

int ControlledDelivery::better_row(double refine) const {
    const size_t next = static_cast<size_t>(row_) + 1;
    // higher order is lost where contact comes and goes
    if (next >= rows_.size() || (row_ == usual_row_ && now_.jumps)) return row_;
    return way().seconds * refine > seconds_to_judge(rows_[next]) ? row_ + 1 : row_;
}

void ControlledDelivery::accept(bool reached) {
    accepted_ = true;
    account_.reached = reached;
    account_.passes.back().purpose = "delivered";
    for (size_t i = 0; i + 1 < account_.passes.size(); ++i)
        account_.seconds += account_.passes[i].cpu_seconds;
    before_.frames.clear();
}

FrameReport ControlledDelivery::deliver() {
    const auto k = static_cast<size_t>(delivered_);
    FrameReport report = now_.frames[k];
    if (!report.trouble.empty()) return report;
    if (k < distance_.size()) {
        const double least = round_off(now_.x[k], now_.steps);
        const double share = stated_share(distance_[k].rms, share_, mean_edge_);
        report.error_rms = share * distance_[k].rms + least;
        report.error_max = share * distance_[k].max + least;
        vertex_error_ = vertex_errors(now_.x[k], before_.x[k], share);
        account_.rms = std::fmax(account_.rms, report.error_rms);
        account_.max = std::fmax(account_.max, report.error_max);
    }
    shown_.x = now_.x[k];
    shown_.time = report.time;
    ++delivered_;
    return report;
}

PassProgress ControlledDelivery::progress() const {
    PassProgress progress;
    progress.what = cat("pass ", account_.passes.size());
    progress.frame = static_cast<int>(now_.x.size());
    progress.frames = frames_;
    for (const ErrorNorms& apart : distance_)
        progress.error = std::fmax(
            progress.error, apart.rms * error_share(now_.refine, before_.refine, order_here(now_.jumps)));
    return progress;
}

}  // namespace drape
