#include "simulate/streamed_delivery.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "simulate/side_by_side.h"

namespace drape {

namespace {

constexpr double companion_steps = 0.867;  // 0.85 / 0.98: as few as stability allows

void record(PassRecord& pass, const Simulation& simulation, const FrameReport& frame, double steps) {
    pass.method = simulation.method().name;
    pass.step = simulation.step();
    pass.steps = static_cast<long>(steps);
    pass.sweeps = simulation.sweeps();
    pass.cpu_seconds += frame.cpu_seconds;
}

}  // namespace

StreamedDelivery::StreamedDelivery(Setup setup, const DeliveryOptions& options)
    : threads_(options.threads), replay_(options.replay) {
    if (options.estimate) {
        Setup other = setup;
        other.refine = companion_steps;
        companion_ = std::make_unique<Simulation>(std::move(other));
    }
    delivered_ = std::make_unique<Simulation>(std::move(setup));
    mean_edge_ = mean_edge(delivered_->model());
    jumps_ = has_jumping_forces(delivered_->model());
    account_.how = companion_ ? "a second pass with another step, beside the first (Richardson)"
                              : cat("no second pass: ", options.no_estimate_because);
    account_.passes.resize(companion_ ? 2 : 1);
    account_.passes[0].purpose = "delivered";
    if (companion_) account_.passes[1].purpose = "for the error";
}

void StreamedDelivery::pace(double steps) {
    const double step = 1 / delivered_->frame_rate() / steps;
    delivered_->ask_step(step);
    if (companion_) companion_->ask_step(step);
}

std::optional<FrameReport> StreamedDelivery::advance() {
    FrameReport report, other;
    if (const auto k = static_cast<size_t>(frame()); k < replay_.size())
        pace(static_cast<double>(replay_[k]));
    if (companion_)
        std::tie(report, other) = advance_both(*delivered_, *companion_, threads_);
    else
        report = delivered_->advance();
    steps_ += static_cast<double>(report.steps);
    companion_steps_ += static_cast<double>(other.steps);
    account_.seconds += other.cpu_seconds;
    record(account_.passes[0], *delivered_, report, steps_);
    if (companion_) record(account_.passes[1], *companion_, other, companion_steps_);
    if (companion_ && !report.trouble.empty() && other.trouble.empty())
        drop_companion(cat("the delivered pass stopped at frame ", report.index, ", the second went on"));
    else if (companion_ && report.trouble.empty())
        judge(report, other);
    account_.passes[0].error_rms = account_.rms;
    return report;
}

void StreamedDelivery::drop_companion(std::string why) {
    account_.how = std::move(why);
    account_.rms = account_.max = NAN;
    companion_.reset();
    vertex_error_.resize(0);
}

void StreamedDelivery::judge(FrameReport& delivered, const FrameReport& companion) {
    if (!companion.trouble.empty()) {
        return drop_companion(cat("not estimated from frame ", companion.index,
                                  " on: the second pass stopped there (", companion.trouble, ")"));
    }
    jumps_ = jumps_ || delivered.contacts > 0 || companion.contacts > 0;
    const int order = delivered_->method().order_where(delivered_->dynamics().is_conservative(), jumps_);
    // contact may bring the numbers of steps together, or turn them round
    const double other_steps = companion_steps_ > steps_ ? std::max(companion_steps_, 1.02 * steps_)
                                                         : std::min(companion_steps_, 0.98 * steps_);
    const Points &x = delivered_->state().x, &y = companion_->state().x;
    const ErrorNorms apart = distance_between(x, y);
    const double richardson = error_share(steps_, other_steps, order);
    const double share = stated_share(apart.rms, richardson, mean_edge_);
    if (share < richardson && !parted_) {
        parted_ = true;
        account_.how += cat("; from t = ", delivered.time,
                            " s on the two have parted, and twice their distance is stated");
    }
    const double least = round_off(x, steps_);
    delivered.error_rms = share * apart.rms + least;
    delivered.error_max = share * apart.max + least;
    vertex_error_ = vertex_errors(x, y, share);
    account_.rms = std::fmax(account_.rms, delivered.error_rms);
    account_.max = std::fmax(account_.max, delivered.error_max);
}

std::string StreamedDelivery::save() const {
    ByteWriter out;
    out.put(companion_ != nullptr);
    delivered_->save(out);
    if (companion_) companion_->save(out);
    for (const double value : {steps_, companion_steps_, account_.rms, account_.max}) out.put(value);
    out.put(jumps_);
    out.put(parted_);
    out.put(account_.how);
    return std::move(out).bytes();
}

bool StreamedDelivery::restore(std::string_view bytes) {
    ByteReader in(bytes);
    const bool two = in.take<bool>();
    if (!delivered_->restore(in)) return false;
    if (two && (!companion_ || !companion_->restore(in))) return false;
    const bool dropped = !two && companion_;
    if (dropped) {
        companion_.reset();
        account_.passes.resize(1);
    }
    for (double* value : {&steps_, &companion_steps_, &account_.rms, &account_.max})
        *value = in.take<double>();
    jumps_ = in.take<bool>();
    parted_ = in.take<bool>();
    std::string how = in.take_text();
    account_.how =
        dropped ? cat("not estimated: the run that was resumed had no second pass (", how, ")") : how;
    return in.at_end();
}

}  // namespace drape
