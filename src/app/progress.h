// How far a run is: a bar on a terminal, at most a line per frame elsewhere, nothing when quiet.
#pragma once

#include <string>

#include "base/timer.h"
#include "simulate/delivery.h"

namespace drape {

class Progress {
public:
    Progress(int first_frame, int frames, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void frame_done(const FrameReport& frame);
    void pass_frame_done(const PassProgress& pass);  // a frame of a pass that is not delivered

private:
    void draw_bar(int frame, const std::string& says);
    int first_, frames_;
    bool quiet_, terminal_, drawn_ = false;
    WallTimer timer_;
};

}  // namespace drape
