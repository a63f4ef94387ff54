// Spreads a budget of wall seconds over the frames of a run: how many steps the next frame can afford.
#pragma once

#include <functional>

namespace drape {

// A budget, and the clock that it is measured with: seconds since the run began, wall time but for tests.
struct Budget {
    double seconds = 0;
    std::function<double()> clock;
};

class Pacer {
public:
    // All but a little of the budget is for `frames` frames; the rest is for what comes after the last one.
    // `step_seconds`: what a step of a frame is expected to take, until frames were measured.
    Pacer(Budget budget, int frames, double step_seconds);

    // Steps that the next frame can afford, given that those after it shall have as many: what is left,
    // less what a frame takes apart from its steps (pictures). `spare`: the share of it to keep back.
    double affordable_steps(double spare) const;

    void begin_frame();
    void end_frame(double steps);

    double step_seconds() const { return step_seconds_; }

private:
    double left() const;  // [s]

    Budget budget_;
    int frames_left_;
    double step_seconds_, other_seconds_ = 0;
    double began_ = 0, ended_ = -1;  // the frame's steps, at the clock [s]
    int gaps_ = 0;                   // between frames, so far
};

}  // namespace drape
