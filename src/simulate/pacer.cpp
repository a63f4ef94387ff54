#include "simulate/pacer.h"

#include <algorithm>

namespace drape {

namespace {

constexpr double used_share = 0.97;    // of the budget, by the end of the last frame
constexpr double newest_weight = 0.3;  // of a frame's measured cost, in the running mean

}  // namespace

Pacer::Pacer(Budget budget, int frames, double step_seconds)
    : budget_(std::move(budget)), frames_left_(frames), step_seconds_(step_seconds) {}

double Pacer::left() const {
    return used_share * budget_.seconds - budget_.clock();
}

double Pacer::affordable_steps(double spare) const {
    // the last frame's picture is drawn after its steps like any other
    const double a_frame = left() / std::max(frames_left_, 1) - other_seconds_;
    return std::max(0.0, a_frame * (1 - spare) / step_seconds_);
}

void Pacer::begin_frame() {
    began_ = budget_.clock();
    if (ended_ < 0) return;
    const double other = began_ - ended_;
    // the first picture takes what is done once, and says little about the others
    other_seconds_ = ++gaps_ <= 2 ? other : (1 - newest_weight) * other_seconds_ + newest_weight * other;
}

void Pacer::end_frame(double steps) {
    ended_ = budget_.clock();
    const double step = (ended_ - began_) / std::max(steps, 1.0);
    step_seconds_ = (1 - newest_weight) * step_seconds_ + newest_weight * step;
    --frames_left_;
}

}  // namespace drape
