#include "app/progress.h"

#include <unistd.h>

#include <algorithm>
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

std::string error_so_far(double error) {
    if (std::isnan(error)) return "";
    char text[48];
    std::snprintf(text, sizeof text, "  error %.2g mm", 1e3 * error);
    return text;
}

}  // namespace

Progress::Progress(int first_frame, int frames, bool quiet)
    : first_(first_frame), frames_(frames), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (drawn_) std::fprintf(stderr, "\n");
}

void Progress::draw_bar(int frame, const std::string& says) {
    constexpr int width = 30;
    const int full = width * frame / frames_;
    const std::string bar =
        std::string(static_cast<size_t>(full), '#') + std::string(static_cast<size_t>(width - full), '.');
    std::fprintf(stderr, "\r[%s] %d/%d  %s \033[K", bar.c_str(), frame, frames_, says.c_str());
    drawn_ = true;
}

void Progress::frame_done(const FrameReport& frame) {
    if (quiet_) return;
    const double left = timer_.seconds() / (frame.index - first_ + 1) * (frames_ - frame.index);
    char says[160];
    std::snprintf(says, sizeof says, "t = %.4g s  %ld steps%s  %s left", frame.time, frame.steps,
                  error_so_far(frame.error_rms).c_str(), minutes(left).c_str());
    if (terminal_)
        draw_bar(frame.index, says);
    else
        std::fprintf(stderr, "frame %d/%d  %s\n", frame.index, frames_, says);
}

void Progress::pass_frame_done(const PassProgress& pass) {
    if (quiet_) return;
    const std::string says = pass.what + error_so_far(pass.error);
    if (terminal_)
        draw_bar(std::min(pass.frame, frames_), says);
    else if (pass.frame == pass.frames)
        std::fprintf(stderr, "%s: %d frames%s\n", pass.what.c_str(), pass.frames,
                     error_so_far(pass.error).c_str());
    if (pass.frame == pass.frames) timer_ = {};  // delivered frames count anew
}

}  // namespace drape
