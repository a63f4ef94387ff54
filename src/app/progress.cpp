#include "app/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace drape {

namespace {

std::string minutes(double seconds) {
    char text[32];
    const int whole = static_cast<int>(std::lround(seconds));
    std::snprintf(text, sizeof text, "%d:%02d", whole / 60, whole % 60);
    return text;
}

}  // namespace

Progress::Progress(int first_frame, int frames, bool quiet)
    : first_(first_frame), frames_(frames), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (drawn_) std::fprintf(stderr, "\n");
}

void Progress::frame_done(int frame, double simulated_time, long steps) {
    if (quiet_) return;
    const double left = timer_.seconds() / (frame - first_ + 1) * (frames_ - frame);
    if (!terminal_) {
        std::fprintf(stderr, "frame %d/%d  t = %.4g s  %ld steps  %s left\n", frame, frames_, simulated_time,
                     steps, minutes(left).c_str());
        return;
    }
    constexpr int width = 30;
    const int full = width * frame / frames_;
    const std::string bar =
        std::string(static_cast<size_t>(full), '#') + std::string(static_cast<size_t>(width - full), '.');
    std::fprintf(stderr, "\r[%s] %d/%d  t = %.3f s  %ld steps  %s left \033[K", bar.c_str(), frame, frames_,
                 simulated_time, steps, minutes(left).c_str());
    drawn_ = true;
}

}  // namespace drape
