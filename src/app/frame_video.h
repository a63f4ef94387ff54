// The frames of a run as a video, encoded while the run goes on.
#pragma once

#include <string>
#include <vector>

#include "video/encoder.h"

namespace drape {

class FrameVideo {
public:
    // Of frames `first` to `last`, which are in `folder` as frame_0001.png and so on when they are asked for
    // again. Throws Error where the video cannot be made.
    FrameVideo(const std::string& path, std::string folder, int first, int last, const Canvas& canvas);

    // Frames come in order. Those left out before, of a run that was resumed, are read from the folder.
    void add(int frame, const Image& image);
    // All frames up to the last are there; the file appears.
    void finish();
    // What encoding took, once finished [s].
    double cpu_seconds() const { return encoder_.cpu_seconds(); }

private:
    void take_pictures_before(int frame);
    void take(int frame, const Image& image);
    Image picture(int frame) const;

    std::string folder_;
    Canvas canvas_;
    int first_, last_, next_;
    std::vector<int> shown_;  // frames counted from the first, ascending
    Encoder encoder_;
};

}  // namespace drape
