// How far a run is: a bar on a terminal, at most a line per frame elsewhere, nothing when quiet.
#pragma once

#include "base/timer.h"

namespace drape {

class Progress {
public:
    Progress(int first_frame, int frames, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void frame_done(int frame, double simulated_time, long steps);

private:
    int first_, frames_;
    bool quiet_, terminal_, drawn_ = false;
    WallTimer timer_;
};

}  // namespace drape
