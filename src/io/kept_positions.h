// The positions of every frame so far, kept beside a checkpoint so that a resumed run's cache is whole: 3 x V
// doubles a frame, one after the other, in native order. What lies behind the frames that a checkpoint counts
// was written after it and does not count.
#pragma once

#include <string>

#include "base/points.h"

namespace drape {

class KeptPositions {
public:
    // Begins at `path`, or goes on behind its first `frames`. Each member throws Error.
    KeptPositions(const std::string& path, Eigen::Index vertices, int frames);
    ~KeptPositions();  // what no checkpoint may count is gone
    KeptPositions(const KeptPositions&) = delete;
    KeptPositions& operator=(const KeptPositions&) = delete;

    Points read(int frame) const;  // counted from 1
    void add(In positions);
    void flush();  // to the disk: from then on a checkpoint may count what was added

private:
    [[noreturn]] void fail(int reason) const;

    std::string path_;
    Eigen::Index vertices_;
    int descriptor_ = -1;
    bool counts_ = false;
};

}  // namespace drape
